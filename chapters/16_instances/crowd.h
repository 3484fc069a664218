/* crowd.h: what there is to be seen: meshes, and where they stand.
 *
 *   crowd c = {mesh, meshes, list, n};               all of it belongs to the caller
 */
#ifndef INSTANCES_CROWD_H
#define INSTANCES_CROWD_H

#include "../07_mesh/mesh.h"
#include "placing.h"

typedef struct { affine to_world; uint32_t mesh; } instance;
typedef struct { const mesh *mesh; size_t meshes; const instance *list; size_t n; } crowd;

#endif
