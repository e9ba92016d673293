#include <grader/decision/bump/Replies.h>

namespace ticker::decision::bump {
namespace {

/// How a tangent of each axis becomes a tilt.
enum class Form {
    direct,        ///< B_u P_u and B_v P_v
    crossProducts  ///< B_u (n x P_v) and B_v (n x P_u): Equation (1)
};

/// The direction in which tangents tilt that belong to a longitude `turn` away.
double turnedAngle(const Reply& reply, const Landing& landing, double turn, Form form,
                   bool slopeAlongU) {
    const Vector3& axis = landing.axis();
    const Vector3& n = reply.direction;
    const Vector3 flat = n - axis * n.dot(axis);
    const Vector3 right = n.cross(axis);
    const Vector3 turned = flat * std::cos(turn) + right * std::sin(turn) + axis * n.dot(axis);
    const Vector3 alongU = landing.alongU(turned);
    const Vector3 alongV = landing.alongV(turned);
    const double sense = landing.mirrored() ? -1.0 : 1.0;
    const Vector3 crossed = slopeAlongU ? alongV.cross(n) : n.cross(alongU);
    const Vector3 direct = slopeAlongU ? alongU : alongV;
    const Vector3 tilt = form == Form::direct ? direct : crossed * sense;
    return std::atan2(tilt.dot(reply.across), tilt.dot(reply.alongSlope));
}

double shareExplained(const Replies& replies, const Landing& landing, double turn, Form form) {
    double explained = 0.0;
    for (const Reply& reply : replies.onU)
        if (near(reply.angle(), turnedAngle(reply, landing, turn, form, true))) explained += 1.0;
    for (const Reply& reply : replies.onV)
        if (near(reply.angle(), turnedAngle(reply, landing, turn, form, false))) explained += 1.0;
    const auto count = static_cast<double>(replies.onU.size() + replies.onV.size());
    return explained / std::max(1.0, count);
}

}  // namespace

double findTangentTurn(const Replies& replies, const Landing& landing) {
    constexpr double kDegrees = 180.0 / std::numbers::pi;
    constexpr int kStep = 10;
    constexpr double kExplained = 0.9;
    for (int turn = 180; turn > -180; turn -= kStep) {
        if (std::abs(turn) < 20) continue;
        for (const Form form : {Form::direct, Form::crossProducts})
            if (shareExplained(replies, landing, turn / kDegrees, form) >= kExplained) return turn;
    }
    return 0.0;
}

}  // namespace ticker::decision::bump
