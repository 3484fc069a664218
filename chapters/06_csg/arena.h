/* arena.h: memory for what a ray needs while it is on its way: one block a thread, kept.
 *
 *   void *p = csg_arena(bytes);      at least so many bytes, for this thread, until its next call
 *
 * The block grows when a ray asks for more than any before it, and never shrinks: after the first
 * ray of a tree no memory is asked for. It goes when its thread ends. Contents: as they were left.
 */
#ifndef CSG_ARENA_H
#define CSG_ARENA_H

#include "../../common/file.h"
#include <pthread.h>

/* ---------------------------------------------------------------------------------------------- */

static _Thread_local void *csg_arena_block;
static _Thread_local size_t csg_arena_room, csg_arena_grown;  /* bytes; how often: to be counted */
static pthread_key_t csg_arena_key;
static pthread_once_t csg_arena_once = PTHREAD_ONCE_INIT;

static inline void csg_arena_begin(void)
{
    if (pthread_key_create(&csg_arena_key, free) != 0) die(1, "no key for the memory of threads");
}

__attribute__((noinline, cold))
static void csg_arena_grow(size_t bytes)
{
    (void)pthread_once(&csg_arena_once, csg_arena_begin);
    free(csg_arena_block);
    csg_arena_room = bytes < SIZE_MAX / 2 ? bytes + bytes / 2 : bytes;
    csg_arena_block = allocate(csg_arena_room, 1);
    csg_arena_grown++;
    if (pthread_setspecific(csg_arena_key, csg_arena_block) != 0)  /* the end of the thread frees */
        die(1, "no memory for a thread's pointer");
}

static inline void *csg_arena(size_t bytes)
{
    if (bytes > csg_arena_room) csg_arena_grow(bytes);
    return csg_arena_block;
}

#endif
