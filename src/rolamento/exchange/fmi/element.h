/* A rolling bearing as a force element: its numbers, which stand in table.c, and what it answers. */

#ifndef ELEMENT_H
#define ELEMENT_H

#define FIVE 5

enum {
    TIME = 0,
    PLACE = 1,       /* x, y, z (m), ry, rz (rad): of the inner ring against the outer one */
    VELOCITY = 6,    /* m/s and rad/s */
    QUANTITY = 11,   /* over which the table goes */
    FORCE = 12,      /* fx, fy, fz (N), my, mz (N m): that the shaft puts on the inner ring */
    DAMPING = 17,    /* s: damping over stiffness */
    OUTSIDE = 18     /* whether the quantity is beyond the table */
};

/* table.c */
extern const char element_token[];
extern const int table_points;
extern const double table_quantity[];           /* rising */
extern const double table_force[];              /* points x 5 */
extern const double table_place[];              /* points x 5 */
extern const double table_stiffness[];          /* points x 5 x 5 */
extern const double start_quantity;
extern const double start_damping;

typedef struct {
    double time;
    double place[FIVE];
    double velocity[FIVE];
    double quantity;
    double damping;
} Element;

void element_start(Element *one);
int element_get(const Element *one, unsigned reference, double *value);
int element_set(Element *one, unsigned reference, double value);
int element_outside(const Element *one);
void element_force(const Element *one, double force[FIVE]);

/* dF/d(known) of one force; 0 if there is no such pair. */
int element_derivative(const Element *one, unsigned unknown, unsigned known, double *value);

#endif
