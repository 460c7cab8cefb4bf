#ifndef MOTION_H
#define MOTION_H
/* Axis limits of the demo board */
#include <stdint.h>
#define G0_RAPID 5000
#define G1_FEED  1200
#define M3_ON    1

typedef struct { float x, y, z; } point_t;
int move_to(const point_t *p, float f);
static inline float sq(float x1) { return x1 * x1; }
#endif
