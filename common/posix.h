/* posix.h: asks the C library for POSIX (clocks, threads, files), which -std=c11 hides, so it must
 * come before the C library's headers: include this project's headers first. */
#ifndef POSIX_H
#define POSIX_H
#if defined __GLIBC__ && !defined __USE_XOPEN2K8
#error "a header of the C library came first: include this project's headers before it"
#endif
#ifndef _XOPEN_SOURCE
#define _XOPEN_SOURCE 700  /* POSIX.1-2008, with realpath */
#endif
#ifndef _DARWIN_C_SOURCE
#define _DARWIN_C_SOURCE   /* macOS: the number of processors */
#endif
#endif
