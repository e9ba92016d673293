#ifndef TICKER_CLI_HOME_H
#define TICKER_CLI_HOME_H

#include <filesystem>

namespace ticker::cli {

/// Folders of ticker's programs and data, found from the running program, so that a checkout or an
/// installation works anywhere.
struct Home {
    std::filesystem::path programs;  ///< ticker, tick1star-reference, tick1star-template
    std::filesystem::path data;      ///< contains scenes/, assets/, grader/corpus/samples/, ...

    /// From the environment's TICKER_HOME (data only; empty: as if it were not set); otherwise from
    /// the checkout or installation of the running program.
    /// @throws raytracer::InputError if TICKER_HOME has no scenes/ or no assets/, raytracer::Error
    ///         (notGradable) if it is not set and they are nowhere else.
    [[nodiscard]] static Home find();

    [[nodiscard]] std::filesystem::path scenes() const { return data / "scenes"; }
    [[nodiscard]] std::filesystem::path assets() const { return data / "assets"; }
    [[nodiscard]] std::filesystem::path studentView() const {
        return data / "grader" / "report" / "student-view.json";
    }
};

}  // namespace ticker::cli

#endif
