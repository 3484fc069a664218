/* name_table.h: names, each kept once and known by a number: materials, files, meshes by name.
 *
 *   name_table t = {0};
 *   uint32_t k = name_add(&t, "red");      0, 1, 2 .. in the order of their first coming
 *   uint32_t k = name_find(&t, "red");     name_none if it never came: O(1)
 *   const char *s = name_text(&t, k);      good until the next name_add
 *   name_table_free(&t);                   a zeroed one may be freed
 *
 * Hashed by FNV-1a (G. Fowler, L. Noll, K. Vo, 1991), open addressing, at most half full.
 */
#ifndef EFFECTS_NAME_TABLE_H
#define EFFECTS_NAME_TABLE_H

#include "../../../common/file.h"

#define name_none UINT32_MAX

typedef struct {
    char *text;               /* all names, each ended by a 0 */
    size_t size, room;
    size_t *at;               /* [n] where name k begins */
    size_t n, at_room;
    uint32_t *slot;           /* [slots] number + 1 of a name; 0: empty */
    size_t slots;             /* a power of two, or 0 */
} name_table;

/* ---------------------------------------------------------------------------------------------- */

static inline void name_table_free(name_table *t)
{
    free(t->text), free(t->at), free(t->slot);
    *t = (name_table){0};
}

static inline const char *name_text(const name_table *t, uint32_t k) { return t->text + t->at[k]; }

/* Where the name is, or where it would go; the table is not empty. */
static inline size_t name_slot(const name_table *t, const char *name)
{
    uint64_t h = 14695981039346656037u;
    for (const char *p = name; *p; p++) h = (h ^ (uint8_t)*p) * 1099511628211u;
    size_t i = (size_t)(h ^ h >> 32) & (t->slots - 1);
    while (t->slot[i] && strcmp(name_text(t, t->slot[i] - 1), name) != 0)
        i = (i + 1) & (t->slots - 1);
    return i;
}

static inline uint32_t name_find(const name_table *t, const char *name)
{
    uint32_t k = t->slots ? t->slot[name_slot(t, name)] : 0;
    return k ? k - 1 : name_none;
}

static inline void name_table_grow(name_table *t)
{
    free(t->slot);
    t->slots = t->slots ? 2 * t->slots : 64;
    t->slot = allocate(t->slots, sizeof *t->slot);
    for (uint32_t k = 0; k < t->n; k++) t->slot[name_slot(t, name_text(t, k))] = k + 1;
}

static inline uint32_t name_add(name_table *t, const char *name)
{
    if (2 * (t->n + 1) > t->slots) name_table_grow(t);
    size_t i = name_slot(t, name), size = strlen(name) + 1;
    if (t->slot[i]) return t->slot[i] - 1;
    while (t->size + size > t->room) {  /* `grown` makes room for one more item: here, for a name */
        size_t room = t->room;
        t->text = grown(t->text, room, &t->room, 1);
    }
    t->at = grown(t->at, t->n, &t->at_room, sizeof *t->at);
    memcpy(t->text + t->size, name, size);
    t->at[t->n++] = t->size;
    t->size += size;
    return (t->slot[i] = (uint32_t)t->n) - 1;
}

#endif
