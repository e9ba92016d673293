// Linked only for GCC's coverage counters, in place of _exit: workers and guards end by it, and it
// writes no counters.
extern "C" {
#include <gcov.h>  // has C linkage, but does not say so before GCC 13

[[noreturn]] void __real__exit(int status);

[[noreturn]] void __wrap__exit(int status) {
    __gcov_dump();
    __real__exit(status);
}

[[noreturn]] void __wrap__Exit(int status) {
    __wrap__exit(status);
}
}
