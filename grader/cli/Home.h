#ifndef TICKER_CLI_HOME_H
#define TICKER_CLI_HOME_H

#include <filesystem>

namespace ticker::cli {

/// Where ticker's own programs and data lie. Found from the running program, so that a checkout or
/// an installation works wherever it is.
struct Home {
    std::filesystem::path programs;  ///< ticker, tick1star-reference, tick1star-template
    std::filesystem::path data;      ///< holds scenes/, assets/, grader/corpus/samples/, ...

    /// From the environment's TICKER_HOME (data alone), else the checkout or the installation that
    /// the running program belongs to.
    /// @throws raytracer::Error (notGradable) where neither has scenes/.
    [[nodiscard]] static Home find();

    [[nodiscard]] std::filesystem::path scenes() const { return data / "scenes"; }
    [[nodiscard]] std::filesystem::path assets() const { return data / "assets"; }
    [[nodiscard]] std::filesystem::path rubric() const {
        return data / "grader" / "rubric" / "rubric.json";
    }
    [[nodiscard]] std::filesystem::path studentView() const {
        return data / "grader" / "report" / "student-view.json";
    }
};

}  // namespace ticker::cli

#endif
