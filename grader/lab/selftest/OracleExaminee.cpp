#include <grader/lab/selftest/OracleExaminee.h>

#include <grader/oracle/Oracle.h>

#include <variant>

namespace ticker::selftest {
namespace {

struct Reply {
    const OracleExaminee& student;

    probe::Answer operator()(const probe::RenderQuestion& question) const {
        probe::RenderAnswer answer;
        answer.state = probe::AnswerState::answered;
        answer.width = question.settings.imageWidth();
        answer.height = question.settings.imageHeight();
        raytracer::RenderSettings settings = question.settings;
        for (int i = 0; i < question.repetitions; ++i, ++settings.seed)
            answer.images.push_back(student.render(question.scene, settings));
        return answer;
    }
    probe::Answer operator()(const probe::NormalQuestion& /*question*/) const {
        return probe::NormalAnswer{};
    }
    probe::Answer operator()(const probe::HitQuestion& /*question*/) const {
        return probe::HitAnswer{};
    }
    // One for each kind of question: a template would give a new kind an answer of the wrong type.
    probe::Answer operator()(const probe::IlluminateQuestion& /*question*/) const {
        return probe::IlluminateAnswer{};
    }
    probe::Answer operator()(const probe::TraceQuestion& /*question*/) const {
        return probe::IlluminateAnswer{};
    }
    probe::Answer operator()(const probe::CallQuestion& /*question*/) const {
        return probe::CallAnswer{};
    }
};

}  // namespace

probe::Run OracleExaminee::ask(const std::vector<probe::Question>& questions) {
    probe::Run run;
    for (const probe::Question& question : questions)
        run.answers.push_back(std::visit(Reply{*this}, question));
    return run;
}

std::vector<raytracer::ColourRGB> OracleExaminee::render(const raytracer::SceneDescription& scene,
                                                         raytracer::RenderSettings settings) const {
    oracle::Reading reading = reading_;
    oracle::Mistake mistake = mistake_;
    if (isPinhole_) {
        settings.dofRayCount = settings.shadowRayCount = 1;
        reading.lightShape = oracle::LightShape::centre;
        mistake.aperture = oracle::Mistake::Aperture::none;
    }
    return oracle::Oracle{scene, settings, reading, mistake}.studentRender(settings.seed).pixels();
}

}  // namespace ticker::selftest
