#include <grader/tasks/bump/questions/Tilt.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <variant>

namespace ticker::tasks::bump {
namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

raytracer::ColourRGB drawColour(Draws& draws) {
    return {draws.uniform(0.05, 1.0), draws.uniform(0.05, 1.0), draws.uniform(0.05, 1.0)};
}

Vector3 drawPlace(Draws& draws) {
    return {draws.uniform(-5.0, 5.0), draws.uniform(-3.0, 3.0), draws.uniform(-2.0, 12.0)};
}

raytracer::Material drawMaterial(Draws& draws) {
    raytracer::Material material;
    material.colour = drawColour(draws);
    // Half of the materials have a colour alone, as in most scene files.
    if (draws.integer(0, 1) == 0) return material;
    material.phongKD = draws.uniform(0.3, 1.0);
    material.phongKS = draws.uniform(0.0, 1.5);
    material.phongAlpha = draws.uniform(2.0, 40.0);
    material.reflectivity = draws.uniform(0.0, 0.6);
    return material;
}

/// Lights as in the handout's scenes and, sometimes, other objects.
raytracer::SceneDescription drawCompany(Draws& draws) {
    raytracer::SceneDescription scene;
    scene.ambientLighting = drawColour(draws) * 0.1;
    for (int i = draws.integer(1, 3); i > 0; --i) {
        const Vector3 place = drawPlace(draws);
        scene.pointLights.emplace_back(place, drawColour(draws), 100.0);
    }
    for (int i = draws.integer(0, 2); i > 0; --i) {
        const Vector3 place = drawPlace(draws);
        scene.spheres.push_back({place, draws.uniform(0.2, 1.0), drawMaterial(draws), nullptr});
    }
    if (draws.integer(0, 2) == 0)
        scene.planes.push_back({{0.0, -4.0, 0.0}, {0.0, 1.0, 0.0}, drawMaterial(draws)});
    return scene;
}

}  // namespace

probe::HeightMapDescription noiseMap(Draws& draws, int width, int height) {
    probe::HeightMapDescription map{width, height, {}, {}, {}};
    for (int i = 0; i < width * height; ++i)
        map.bytes.push_back(static_cast<std::uint8_t>(draws.integer(0, 255)));
    return map;
}

probe::HeightMapDescription flatMap(int width, int height, double level) {
    return {width,
            height,
            {},
            std::vector<double>(static_cast<std::size_t>(width), level),
            std::vector<double>(static_cast<std::size_t>(height), 0.0)};
}

std::size_t Questionnaire::add(const Ball& ball, probe::HeightMapDescription map,
                               const std::vector<Vector3>& directions) {
    probe::NormalQuestion question;
    question.centre = ball.centre;
    question.radius = ball.radius;
    question.material = drawMaterial(draws_);
    question.company = drawCompany(draws_);
    question.map = std::move(map);
    question.positions.reserve(directions.size());
    for (const Vector3& direction : directions)
        question.positions.push_back(ball.at(direction));
    questions_.emplace_back(std::move(question));
    return questions_.size() - 1;
}

LevelPair Questionnaire::addPair(const Ball& ball, probe::HeightMapDescription map,
                                 const std::vector<Vector3>& directions) {
    const std::size_t flat = add(ball, flatMap(map.width, map.height), directions);
    return {flat, add(ball, std::move(map), directions)};
}

OrderPair Questionnaire::addInBothOrders(const Ball& ball, const probe::HeightMapDescription& map,
                                         const std::vector<Vector3>& directions) {
    const std::size_t forwards = add(ball, map, directions);
    return {forwards, add(ball, map, {directions.rbegin(), directions.rend()})};
}

const probe::NormalQuestion& Questionnaire::question(std::size_t number) const {
    return std::get<probe::NormalQuestion>(questions_.at(number));
}

Answers::Answers(const Questionnaire& asked, probe::Run run)
    : asked_(&asked), run_(std::move(run)) {
    run_.answers.resize(asked.questions().size());
    for (std::size_t i = 0; i < run_.answers.size(); ++i) {
        if (!std::holds_alternative<probe::NormalAnswer>(run_.answers[i]))
            run_.answers[i] = probe::NormalAnswer{};
        std::get<probe::NormalAnswer>(run_.answers[i])
            .normals.resize(asked.question(i).positions.size(), {kNothing, kNothing, kNothing});
    }
}

const probe::NormalAnswer& Answers::answer(std::size_t number) const {
    return std::get<probe::NormalAnswer>(run_.answers.at(number));
}

std::vector<Vector3> Answers::tilts(std::size_t number) const {
    const probe::NormalQuestion& question = asked_->question(number);
    const std::vector<Vector3>& normals = answer(number).normals;
    std::vector<Vector3> tilts;
    tilts.reserve(normals.size());
    for (std::size_t i = 0; i < normals.size(); ++i) {
        const Vector3 smooth = (question.positions[i] - question.centre).normalised();
        tilts.push_back(tiltOf(normals[i], smooth));
    }
    return tilts;
}

std::vector<Vector3> Answers::tiltsBeyond(std::size_t flat, std::size_t number) const {
    const std::vector<Vector3> level = tilts(flat);
    std::vector<Vector3> result = tilts(number);
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] -= level.at(i);
    return result;
}

double Answers::shareThatOrderChanges(const OrderPair& pair) const {
    constexpr double kRounding = 1e-9;
    const std::vector<Vector3> one = tilts(pair.forwards);
    std::vector<Vector3> two = tilts(pair.backwards);
    std::ranges::reverse(two);
    double changed = 0.0;
    for (std::size_t i = 0; i < one.size(); ++i)
        if ((one[i] - two.at(i)).magnitude() > kRounding) changed += 1.0;
    return one.empty() ? 0.0 : changed / static_cast<double>(one.size());
}

}  // namespace ticker::tasks::bump
