/* tax.c: what being general costs, as a table: `make tax`, and part of `make full-27`. A program of
 * its own, for it compiles the rays and paths of 18, 19 and 26 beside those of 27. With --verdict,
 * as `make tax` asks, it says whether all is as fast as it should be; exit 1: it is not. */
#include "tax.h"

int main(int argc, char **argv)
{
    bool quick = argc == 2 && strcmp(argv[1], "--quick") == 0;
    bool verdict = argc == 2 && strcmp(argv[1], "--verdict") == 0;
    double least;
    options o = options_read(1, argv, "27_tax", "", (options){.width = 1, .height = 1}, NULL);
    if (argc > 1 && !quick && !verdict)
        die(2, "a table of times, on one thread: allowed is --quick or --verdict");
    o.quick = quick;
    if (!table_of_tax(&o, &least)) return parallel_stopped();
    return !verdict || tax_verdict(least) ? 0 : 1;
}
