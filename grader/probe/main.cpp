// The probe program: linked with a submission and run in the sandbox. Questions come on descriptor
// 3, answers go to the memory behind descriptor 4. It opens no file, prints nothing and contains no
// expected answer.
#include <grader/probe/Respond.h>
#include <grader/probe/Wire.h>

#include <raytracer/base/Error.h>

#include <malloc.h>
#include <pthread.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>
#include <cstdlib>
#include <exception>
#include <new>

namespace {

constexpr int kQuestions = 3;
constexpr int kAnswers = 4;

std::span<std::byte> mapped(int descriptor, int protection, int flags) {
    // The system call filter does not allow fstat(): the C library implements it by a system call
    // that takes a path.
    const off_t end = lseek(descriptor, 0, SEEK_END);
    if (end <= 0) throw raytracer::Error("a descriptor is missing");
    const auto size = static_cast<std::size_t>(end);
    void* memory = mmap(nullptr, size, protection, flags, descriptor, 0);
    if (memory == MAP_FAILED) throw raytracer::Error("a descriptor cannot be mapped");
    return {static_cast<std::byte*>(memory), size};
}

// Some submissions start a thread for each row of a picture. With glibc's default sizes, that many
// stacks and heaps would not fit into a submission's memory limit.
void makeRoomForThreads() {
    constexpr std::size_t kStackBytes = 2U << 20U;
    constexpr int kHeaps = 4;
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    pthread_attr_setstacksize(&attributes, kStackBytes);
    pthread_setattr_default_np(&attributes);
    pthread_attr_destroy(&attributes);
    mallopt(M_ARENA_MAX, kHeaps);
}

// A question's height map takes some megabytes. With glibc's default limits its memory goes back to
// the kernel before the next one, and every page comes anew.
void keepFreedMemory() {
    constexpr int kLargestKept = 32 << 20;  // glibc takes no more
    constexpr int kMostKept = 64 << 20;     // free memory at the end of a heap
    mallopt(M_MMAP_THRESHOLD, kLargestKept);
    mallopt(M_TRIM_THRESHOLD, kMostKept);
}

}  // namespace

// Defined here, so that the linker refuses a submission with an _Exit of its own, which would run
// after the last answer, outside of all questions. The system call is made directly, since a
// submission may define any other function on the way to the kernel.
extern "C" [[noreturn]] void _Exit(int status) noexcept {
#if defined(__x86_64__)
    while (true)
        asm volatile("syscall" : : "a"(SYS_exit_group), "D"(status) : "rcx", "r11", "memory");
#else
    while (true)
        syscall(SYS_exit_group, status);
#endif
}

int main() {
    using namespace ticker::probe;
    makeRoomForThreads();
    keepFreedMemory();
    try {
        const auto questions = decodeQuestions(mapped(kQuestions, PROT_READ, MAP_PRIVATE));
        respond(questions, mapped(kAnswers, PROT_READ | PROT_WRITE, MAP_SHARED));
        // Everything is answered: skip the submission's destructors, operator delete and atexit
        // functions.
        _Exit(0);
    } catch (const std::bad_alloc&) {
        throw;  // memory ran out between two answers: the abort's message reports it
    } catch (const std::exception&) {
        _Exit(raytracer::toInt(raytracer::ExitCode::notGradable));
    }
}
