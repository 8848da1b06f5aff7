/* The functions of FMI 2.0 for model exchange and co-simulation: no states, no events. */

#include "fmi2Functions.h"

#include <stdlib.h>
#include <string.h>

#include "element.h"

#define ONE ((Element *)c)

const char *fmi2GetTypesPlatform(void) { return fmi2TypesPlatform; }
const char *fmi2GetVersion(void) { return fmi2Version; }

fmi2Component fmi2Instantiate(fmi2String instanceName, fmi2Type fmuType, fmi2String fmuGUID,
                              fmi2String fmuResourceLocation,
                              const fmi2CallbackFunctions *functions, fmi2Boolean visible,
                              fmi2Boolean loggingOn)
{
    Element *one;
    (void)instanceName; (void)fmuType; (void)fmuResourceLocation; (void)functions;
    (void)visible; (void)loggingOn;
    if (fmuGUID == 0 || strcmp(fmuGUID, element_token) != 0) {
        return 0;
    }
    one = calloc(1, sizeof(Element));
    if (one != 0) {
        element_start(one);
    }
    return one;
}

void fmi2FreeInstance(fmi2Component c) { free(c); }

fmi2Status fmi2SetDebugLogging(fmi2Component c, fmi2Boolean loggingOn, size_t nCategories,
                               const fmi2String categories[])
{
    (void)c; (void)loggingOn; (void)nCategories; (void)categories;
    return fmi2OK;
}

fmi2Status fmi2SetupExperiment(fmi2Component c, fmi2Boolean toleranceDefined, fmi2Real tolerance,
                               fmi2Real startTime, fmi2Boolean stopTimeDefined, fmi2Real stopTime)
{
    (void)toleranceDefined; (void)tolerance; (void)stopTimeDefined; (void)stopTime;
    ONE->time = startTime;
    return fmi2OK;
}

fmi2Status fmi2EnterInitializationMode(fmi2Component c) { (void)c; return fmi2OK; }
fmi2Status fmi2ExitInitializationMode(fmi2Component c) { (void)c; return fmi2OK; }
fmi2Status fmi2Terminate(fmi2Component c) { (void)c; return fmi2OK; }
fmi2Status fmi2Reset(fmi2Component c) { element_start(ONE); return fmi2OK; }

/* --- variables ------------------------------------------------------------------------------- */

fmi2Status fmi2GetReal(fmi2Component c, const fmi2ValueReference vr[], size_t nvr, fmi2Real value[])
{
    size_t i;
    for (i = 0; i < nvr; i++) {
        if (!element_get(ONE, vr[i], &value[i])) {
            return fmi2Error;
        }
    }
    return fmi2OK;
}

fmi2Status fmi2SetReal(fmi2Component c, const fmi2ValueReference vr[], size_t nvr,
                       const fmi2Real value[])
{
    size_t i;
    for (i = 0; i < nvr; i++) {
        if (!element_set(ONE, vr[i], value[i])) {
            return fmi2Error;
        }
    }
    return fmi2OK;
}

fmi2Status fmi2GetBoolean(fmi2Component c, const fmi2ValueReference vr[], size_t nvr,
                          fmi2Boolean value[])
{
    size_t i;
    for (i = 0; i < nvr; i++) {
        if (vr[i] != OUTSIDE) {
            return fmi2Error;
        }
        value[i] = element_outside(ONE) ? fmi2True : fmi2False;
    }
    return fmi2OK;
}

#define NONE(name, type)                                                                          \
    fmi2Status name(fmi2Component c, const fmi2ValueReference vr[], size_t nvr, type value[])     \
    {                                                                                             \
        (void)c; (void)vr; (void)value;                                                           \
        return nvr == 0 ? fmi2OK : fmi2Error;                                                     \
    }

NONE(fmi2GetInteger, fmi2Integer)
NONE(fmi2GetString, fmi2String)
NONE(fmi2SetInteger, const fmi2Integer)
NONE(fmi2SetBoolean, const fmi2Boolean)
NONE(fmi2SetString, const fmi2String)

fmi2Status fmi2GetDirectionalDerivative(fmi2Component c, const fmi2ValueReference vUnknown_ref[],
                                        size_t nUnknown, const fmi2ValueReference vKnown_ref[],
                                        size_t nKnown, const fmi2Real dvKnown[],
                                        fmi2Real dvUnknown[])
{
    size_t i, j;
    for (i = 0; i < nUnknown; i++) {
        dvUnknown[i] = 0.0;
        for (j = 0; j < nKnown; j++) {
            double value;
            if (!element_derivative(ONE, vUnknown_ref[i], vKnown_ref[j], &value)) {
                return fmi2Error;
            }
            dvUnknown[i] += value * dvKnown[j];
        }
    }
    return fmi2OK;
}

/* --- model exchange -------------------------------------------------------------------------- */

fmi2Status fmi2EnterEventMode(fmi2Component c) { (void)c; return fmi2OK; }
fmi2Status fmi2EnterContinuousTimeMode(fmi2Component c) { (void)c; return fmi2OK; }
fmi2Status fmi2SetTime(fmi2Component c, fmi2Real time) { ONE->time = time; return fmi2OK; }

fmi2Status fmi2NewDiscreteStates(fmi2Component c, fmi2EventInfo *info)
{
    (void)c;
    info->newDiscreteStatesNeeded = fmi2False;
    info->terminateSimulation = fmi2False;
    info->nominalsOfContinuousStatesChanged = fmi2False;
    info->valuesOfContinuousStatesChanged = fmi2False;
    info->nextEventTimeDefined = fmi2False;
    info->nextEventTime = 0.0;
    return fmi2OK;
}

fmi2Status fmi2CompletedIntegratorStep(fmi2Component c, fmi2Boolean noSetFMUStatePriorToCurrentPoint,
                                       fmi2Boolean *enterEventMode, fmi2Boolean *terminateSimulation)
{
    (void)c; (void)noSetFMUStatePriorToCurrentPoint;
    *enterEventMode = fmi2False;
    *terminateSimulation = fmi2False;
    return fmi2OK;
}

#define NO_STATES(name, type)                                                                     \
    fmi2Status name(fmi2Component c, type x[], size_t nx)                                         \
    {                                                                                             \
        (void)c; (void)x;                                                                         \
        return nx == 0 ? fmi2OK : fmi2Error;                                                      \
    }

NO_STATES(fmi2SetContinuousStates, const fmi2Real)
NO_STATES(fmi2GetContinuousStates, fmi2Real)
NO_STATES(fmi2GetDerivatives, fmi2Real)
NO_STATES(fmi2GetNominalsOfContinuousStates, fmi2Real)
NO_STATES(fmi2GetEventIndicators, fmi2Real)

/* --- co-simulation --------------------------------------------------------------------------- */

fmi2Status fmi2DoStep(fmi2Component c, fmi2Real currentCommunicationPoint,
                      fmi2Real communicationStepSize, fmi2Boolean noSetFMUStatePriorToCurrentPoint)
{
    (void)noSetFMUStatePriorToCurrentPoint;
    ONE->time = currentCommunicationPoint + communicationStepSize;
    return fmi2OK;
}

fmi2Status fmi2CancelStep(fmi2Component c) { (void)c; return fmi2Error; }

fmi2Status fmi2SetRealInputDerivatives(fmi2Component c, const fmi2ValueReference vr[], size_t nvr,
                                       const fmi2Integer order[], const fmi2Real value[])
{
    (void)c; (void)vr; (void)order; (void)value;
    return nvr == 0 ? fmi2OK : fmi2Error;
}

fmi2Status fmi2GetRealOutputDerivatives(fmi2Component c, const fmi2ValueReference vr[], size_t nvr,
                                        const fmi2Integer order[], fmi2Real value[])
{
    (void)c; (void)vr; (void)order; (void)value;
    return nvr == 0 ? fmi2OK : fmi2Error;
}

#define NO_STATUS(name, type)                                                                     \
    fmi2Status name(fmi2Component c, const fmi2StatusKind s, type *value)                         \
    {                                                                                             \
        (void)c; (void)s; (void)value;                                                            \
        return fmi2Discard;                                                                       \
    }

NO_STATUS(fmi2GetStatus, fmi2Status)
NO_STATUS(fmi2GetIntegerStatus, fmi2Integer)
NO_STATUS(fmi2GetBooleanStatus, fmi2Boolean)
NO_STATUS(fmi2GetStringStatus, fmi2String)

fmi2Status fmi2GetRealStatus(fmi2Component c, const fmi2StatusKind s, fmi2Real *value)
{
    if (s != fmi2LastSuccessfulTime) {
        return fmi2Discard;
    }
    *value = ONE->time;
    return fmi2OK;
}

/* --- states are not kept: there are none ------------------------------------------------------ */

fmi2Status fmi2GetFMUstate(fmi2Component c, fmi2FMUstate *state)
{
    (void)c; (void)state;
    return fmi2Error;
}

fmi2Status fmi2SetFMUstate(fmi2Component c, fmi2FMUstate state)
{
    (void)c; (void)state;
    return fmi2Error;
}

fmi2Status fmi2FreeFMUstate(fmi2Component c, fmi2FMUstate *state)
{
    (void)c; (void)state;
    return fmi2Error;
}

fmi2Status fmi2SerializedFMUstateSize(fmi2Component c, fmi2FMUstate state, size_t *size)
{
    (void)c; (void)state; (void)size;
    return fmi2Error;
}

fmi2Status fmi2SerializeFMUstate(fmi2Component c, fmi2FMUstate state, fmi2Byte bytes[], size_t size)
{
    (void)c; (void)state; (void)bytes; (void)size;
    return fmi2Error;
}

fmi2Status fmi2DeSerializeFMUstate(fmi2Component c, const fmi2Byte bytes[], size_t size,
                                   fmi2FMUstate *state)
{
    (void)c; (void)bytes; (void)size; (void)state;
    return fmi2Error;
}
