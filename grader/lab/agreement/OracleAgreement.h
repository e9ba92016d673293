#ifndef TICKER_CALIBRATE_ORACLEAGREEMENT_H
#define TICKER_CALIBRATE_ORACLEAGREEMENT_H

#include <grader/build/Kit.h>
#include <grader/build/Program.h>
#include <grader/lab/agreement/AgreementCases.h>
#include <grader/lab/calibrate/Campaign.h>
#include <grader/sandbox/Sandbox.h>

#include <raytracer/scene/SceneDescription.h>

#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace ticker::calibrate {

/// What the oracle is compared with.
struct AgreementPlan {
    std::filesystem::path scenes;     ///< every *.xml in it but `leftOut`
    std::filesystem::path assets;     ///< maps of the scenes
    std::filesystem::path reference;  ///< the reference solution's two files
    std::vector<AgreementCase> cases;
    std::vector<std::string> leftOut = {};  ///< scenes of other exercises, by name
    int rounds = 1;  ///< repetitions of each case with noise and each scene, with fresh seeds
};

/// Validates the oracle against the reference solution, which is edited to each accepted reading,
/// compiled, and asked in the sandbox like a submission, on every scene.
///
/// Readings with noise are compared by the means of tiles of 6 x 6 pixels and the variance of the
/// whole picture, as z-scores. Bump readings have no noise and are compared pixel by pixel.
class OracleAgreement final : public Campaign {
public:
    /// `kit` and `sandbox` must outlive this object.
    /// @throws raytracer::InputError if a scene cannot be read.
    OracleAgreement(AgreementPlan plan, const build::Kit& kit, const sandbox::Sandbox& sandbox);

    [[nodiscard]] std::string name() const override { return "oracle"; }
    [[nodiscard]] std::size_t units() const override { return units_.size(); }
    [[nodiscard]] std::string unitName(std::size_t unit) const override;
    [[nodiscard]] Basis basisOf(std::size_t unit) const override;
    [[nodiscard]] std::vector<std::size_t> checkUnits() const override;
    [[nodiscard]] std::string run(std::size_t unit) override;
    [[nodiscard]] bool agrees(const std::string& before, const std::string& now) const override;
    [[nodiscard]] Summary summarise(const std::vector<std::string>& records) const override;

    /// Names of a unit's reading and scene.
    [[nodiscard]] std::pair<std::string, std::string> nameOf(std::size_t unit) const;

private:
    struct Scene {
        std::string name;
        std::string text;  // of its file
        raytracer::SceneDescription description;
    };
    struct Unit {
        std::size_t reading = 0;
        std::size_t scene = 0;
        int round = 0;
    };

    [[nodiscard]] std::string sourceOf(const AgreementCase& wanted) const;
    [[nodiscard]] std::shared_ptr<const build::Program> programOf(std::size_t reading);
    [[nodiscard]] std::string runNoisy(std::size_t number, const build::Program& program) const;
    [[nodiscard]] std::string runBump(const Unit& unit, const build::Program& program) const;

    AgreementPlan plan_;
    const build::Kit& kit_;
    const sandbox::Sandbox& sandbox_;
    std::vector<Scene> scenes_;
    std::vector<Unit> units_;
    std::mutex mutex_;
    std::map<std::size_t, std::shared_ptr<const build::Program>> programs_;
};

}  // namespace ticker::calibrate

#endif
