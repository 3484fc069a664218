/* tax.c: what being general costs, as a table: `make tax`, and part of `make full-27`. A program of
 * its own, for it compiles the rays and paths of 18, 19 and 26 beside those of 27. */
#include "tax.h"

int main(int argc, char **argv)
{
    bool quick = argc == 2 && strcmp(argv[1], "--quick") == 0;
    options o = options_read(1, argv, "27_tax", "", (options){.width = 1, .height = 1}, NULL);
    if (argc > 1 && !quick) die(2, "a table of times, on one thread: allowed is --quick alone");
    o.quick = quick;
    return table_of_tax(&o) ? 0 : parallel_stopped();
}
