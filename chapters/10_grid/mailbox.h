/* mailbox.h: not asking the same item twice for one ray (邮箱法, mailboxing).
 *
 * Where space is cut, an item may be in many cells, and a ray that passes several of them would
 * test it several times. The mailbox remembers the last items tested: a table of 16 places, item i
 * in place i mod 16. It forgets, and then an item is tested again: that costs time, no more. It
 * lives on the stack of one search, so threads do not disturb each other (a mark kept in the item
 * itself, as first described, would).
 *
 *   mailbox seen = mailbox_new();
 *   if (!mailbox_has(&seen, i)) test item i;     notes it down
 *   mailbox_ask(&seen, on, &q, &x, i, end, any, &work)     so with the items *i of a cell, up to
 *                                                *end; true if one was closer than the best so far
 *                                                (any: was hit). on: false asks all of them
 *
 * Sources: Amanatides, Woo 1987 (see walk.h), section 3; C. Benthin, "Realtime Ray Tracing on
 * Current CPU Architectures", PhD thesis, Saarland University, 2006 (a hashed table of one ray).
 */
#ifndef GRID_MAILBOX_H
#define GRID_MAILBOX_H

#include "../09_aabb/items.h"

enum { mailbox_places = 16 };
typedef struct { uint32_t item[mailbox_places]; } mailbox;

/* ---------------------------------------------------------------------------------------------- */

static inline mailbox mailbox_new(void)  /* UINT32_MAX is the number of no item */
{
    mailbox m;
    memset(&m, 255, sizeof m);
    return m;
}

fast_inline bool mailbox_has(mailbox *m, uint32_t i)
{
    uint32_t *place = &m->item[i % mailbox_places];
    if (*place == i) return true;
    *place = i;
    return false;
}

fast_inline bool mailbox_ask(mailbox *m, bool on, query *q, const items *x, const uint32_t *i,
                             const uint32_t *end, bool any, search_work *work)
{
    bool found = false;
    if (work) work->leaves++;
    for (; i < end; i++) {
        if (on && mailbox_has(m, *i)) continue;
        if (work) work->tests++;
        if (!query_ask(q, x, *i, any)) continue;
        if (any) return true;
        found = true;
    }
    return found;
}

#endif
