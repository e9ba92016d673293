// The probe program: linked with a submission and run in the sandbox. Questions come on descriptor
// 3, answers go to the memory behind descriptor 4. It opens nothing, prints nothing and knows no
// right answer.
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
    // The filter of system calls knows no fstat(): the C library asks for it by path.
    const off_t end = lseek(descriptor, 0, SEEK_END);
    if (end <= 0) throw raytracer::Error("a descriptor is missing");
    const auto size = static_cast<std::size_t>(end);
    void* memory = mmap(nullptr, size, protection, flags, descriptor, 0);
    if (memory == MAP_FAILED) throw raytracer::Error("a descriptor cannot be mapped");
    return {static_cast<std::byte*>(memory), size};
}

// Some start a thread for each row of a picture. As many stacks and heaps as glibc gives to each by
// itself would not fit into the memory that a submission may have.
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

}  // namespace

// Defined here, so that a submission with one of its own is refused by the linker: it would run
// after the last answer, when the submission has nothing left to do. By the instruction itself,
// since a submission may define what else leads to the kernel.
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
    try {
        const auto questions = decodeQuestions(mapped(kQuestions, PROT_READ, MAP_PRIVATE));
        respond(questions, mapped(kAnswers, PROT_READ | PROT_WRITE, MAP_SHARED));
        // Everything is answered: the submission's destructors, its operator delete and its atexit
        // functions do not matter.
        _Exit(0);
    } catch (const std::bad_alloc&) {
        throw;  // what a submission keeps ran out between two answers: the abort's message says so
    } catch (const std::exception&) {
        _Exit(raytracer::toInt(raytracer::ExitCode::notGradable));
    }
}
