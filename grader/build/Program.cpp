#include <grader/build/Program.h>

#include <elf.h>

#include <fstream>

namespace ticker::build {

std::uint64_t Program::staticBytes() const {
    std::ifstream stream{file(), std::ios::binary};
    const auto read = [&](auto& part) {
        return static_cast<bool>(stream.read(reinterpret_cast<char*>(&part), sizeof part));
    };
    Elf64_Ehdr header{};
    if (!read(header) || header.e_phentsize != sizeof(Elf64_Phdr)) return 0;
    stream.seekg(static_cast<std::streamoff>(header.e_phoff));
    std::uint64_t bytes = 0;
    Elf64_Phdr part{};
    for (int i = 0; i < header.e_phnum && read(part); ++i)
        if (part.p_type == PT_LOAD) bytes += part.p_memsz;
    return bytes;
}

}  // namespace ticker::build
