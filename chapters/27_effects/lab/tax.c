/* tax.c: what being general costs, as a table: `make tax`, and part of `make full-27`. A program of
 * its own, for it compiles the rays and paths of 18, 19 and 26 beside those of 27. */
#include "tax.h"

int main(int argc, char **argv)
{
    options o = options_read(argc, argv, "27_tax", "The general program against 18, 19 and 26.",
                             (options){.width = 240, .height = 180, .seed = 1}, NULL);
    return table_of_tax(&o) ? 0 : parallel_stopped();
}
