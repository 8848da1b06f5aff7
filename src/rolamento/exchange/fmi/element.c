/* The force between two points of a table of operating points:

       f = F(s) + K(s) (u - U(s)) + d K(s) v,

   F, U and K linear in the quantity s between the points of the table, and held beyond its ends. */

#include "element.h"

#include <math.h>

void element_start(Element *one)
{
    int i;
    one->time = 0.0;
    for (i = 0; i < FIVE; i++) {
        one->place[i] = 0.0;
        one->velocity[i] = 0.0;
    }
    one->quantity = start_quantity;
    one->damping = start_damping;
}

int element_outside(const Element *one)
{
    return !(one->quantity >= table_quantity[0]
             && one->quantity <= table_quantity[table_points - 1]);
}

/* The point on the left, and the part of the way to the next one. */
static int part_of_way(double quantity, double *part)
{
    int low = 0, high = table_points - 1;
    if (isnan(quantity)) {
        *part = quantity;
        return 0;
    }
    if (high == 0 || quantity <= table_quantity[0]) {
        *part = 0.0;
        return 0;
    }
    if (quantity >= table_quantity[high]) {
        *part = 1.0;
        return high - 1;
    }
    while (high - low > 1) {
        int middle = (low + high) / 2;
        if (table_quantity[middle] <= quantity) {
            low = middle;
        } else {
            high = middle;
        }
    }
    *part = (quantity - table_quantity[low]) / (table_quantity[high] - table_quantity[low]);
    return low;
}

/* A number of a table with so many columns; and by how much it grows with the quantity. */
static double between(const double *table, int columns, int column, double quantity, double *growth)
{
    double part, left, right;
    int low = part_of_way(quantity, &part);
    int next = low + 1 < table_points ? low + 1 : low;
    left = table[low * columns + column];
    right = table[next * columns + column];
    if (growth != 0) {
        double step = table_quantity[next] - table_quantity[low];
        int inside = part > 0.0 && part < 1.0;
        *growth = inside && step > 0.0 ? (right - left) / step : 0.0;
    }
    return part == 1.0 ? right : left + part * (right - left);
}

static double stiffness(const Element *one, int row, int column, double *growth)
{
    return between(table_stiffness, FIVE * FIVE, FIVE * row + column, one->quantity, growth);
}

void element_force(const Element *one, double force[FIVE])
{
    int i, j;
    for (i = 0; i < FIVE; i++) {
        force[i] = between(table_force, FIVE, i, one->quantity, 0);
        for (j = 0; j < FIVE; j++) {
            double moved = one->place[j] - between(table_place, FIVE, j, one->quantity, 0);
            force[i] += stiffness(one, i, j, 0) * (moved + one->damping * one->velocity[j]);
        }
    }
}

int element_get(const Element *one, unsigned reference, double *value)
{
    double force[FIVE];
    if (reference == TIME) {
        *value = one->time;
    } else if (reference >= PLACE && reference < PLACE + FIVE) {
        *value = one->place[reference - PLACE];
    } else if (reference >= VELOCITY && reference < VELOCITY + FIVE) {
        *value = one->velocity[reference - VELOCITY];
    } else if (reference == QUANTITY) {
        *value = one->quantity;
    } else if (reference >= FORCE && reference < FORCE + FIVE) {
        element_force(one, force);
        *value = force[reference - FORCE];
    } else if (reference == DAMPING) {
        *value = one->damping;
    } else {
        return 0;
    }
    return 1;
}

int element_set(Element *one, unsigned reference, double value)
{
    if (reference >= PLACE && reference < PLACE + FIVE) {
        one->place[reference - PLACE] = value;
    } else if (reference >= VELOCITY && reference < VELOCITY + FIVE) {
        one->velocity[reference - VELOCITY] = value;
    } else if (reference == QUANTITY) {
        one->quantity = value;
    } else if (reference == DAMPING && value >= 0.0) {
        one->damping = value;
    } else {
        return 0;
    }
    return 1;
}

int element_derivative(const Element *one, unsigned unknown, unsigned known, double *value)
{
    int i, j;
    if (unknown < FORCE || unknown >= FORCE + FIVE) {
        return 0;
    }
    i = (int)(unknown - FORCE);
    if (known >= PLACE && known < PLACE + FIVE) {
        *value = stiffness(one, i, (int)(known - PLACE), 0);
    } else if (known >= VELOCITY && known < VELOCITY + FIVE) {
        *value = one->damping * stiffness(one, i, (int)(known - VELOCITY), 0);
    } else if (known == QUANTITY) {
        between(table_force, FIVE, i, one->quantity, value);
        for (j = 0; j < FIVE; j++) {
            double grows, moves;
            double k = stiffness(one, i, j, &grows);
            double rest = between(table_place, FIVE, j, one->quantity, &moves);
            *value += grows * (one->place[j] - rest + one->damping * one->velocity[j]) - k * moves;
        }
    } else {
        return 0;
    }
    return 1;
}
