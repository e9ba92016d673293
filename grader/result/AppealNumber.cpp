#include <grader/result/AppealNumber.h>

#include <grader/base/Digest.h>

#include <fmt/core.h>

#include <cstdint>
#include <string>

namespace ticker {

std::string appealNumber(const SubmissionResult& result) {
    constexpr std::size_t kDigits = 15;  // of 4 bits, so that 64 hold them
    constexpr std::uint64_t kHalf = 10'000;
    const std::string digest = Digest{}
                                   .add("appeal")
                                   .add(result.submission)
                                   .add(result.inputs.files)
                                   .add(std::to_string(result.seed))
                                   .text();
    const std::uint64_t number = std::stoull(digest.substr(0, kDigits), nullptr, 16);
    return fmt::format("{:04}-{:04}", number / kHalf % kHalf, number % kHalf);
}

}  // namespace ticker
