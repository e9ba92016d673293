#ifndef TICKER_LAB_EVENSHARE_H
#define TICKER_LAB_EVENSHARE_H

#include <cstddef>
#include <utility>
#include <vector>

namespace ticker::lab {

/// A share of a list, evenly spread and in its order; at least one, unless the list is empty.
/// @param owed  From 0 to 1, the sooner the first one comes.
template <class T>
[[nodiscard]] std::vector<T> evenShare(std::vector<T> all, double fraction, double owed) {
    std::vector<T> share;
    for (T& one : all) {
        owed += fraction;
        if (owed < 1.0) continue;
        owed -= 1.0;
        share.push_back(std::move(one));
    }
    if (share.empty() && !all.empty()) share.push_back(std::move(all.front()));
    return share;
}

}  // namespace ticker::lab

#endif
