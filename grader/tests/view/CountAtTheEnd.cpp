// With GCC's counters only: workers and guards end by _exit, which writes no counters.
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
