#ifndef TICKER_TASKS_SUPPORT_SHELF_H
#define TICKER_TASKS_SUPPORT_SHELF_H

#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <utility>

namespace ticker::tasks {

/// Keeps objects that are expensive to compute and depend on a question alone, for all submissions
/// that get the question. After a few hundred objects it drops all of them and starts again; a
/// caller's pointer stays valid. Several threads may use it.
/// @tparam Key  Distinguishes the questions.
template <class Key, class Kept>
class Shelf {
public:
    /// The object kept under this key; the first call constructs it.
    /// @param arguments  For the constructor of `Kept`.
    template <class... Arguments>
    [[nodiscard]] std::shared_ptr<Kept> of(const Key& key, Arguments&&... arguments) {
        const std::lock_guard lock{mutex_};
        if (kept_.size() >= kMost) kept_.clear();
        std::shared_ptr<Kept>& kept = kept_[key];
        if (!kept) kept = std::make_shared<Kept>(std::forward<Arguments>(arguments)...);
        return kept;
    }

private:
    static constexpr std::size_t kMost = 400;  // about 100 MB of pictures

    std::mutex mutex_;
    std::map<Key, std::shared_ptr<Kept>> kept_;
};

}  // namespace ticker::tasks

#endif
