#include <grader/tasks/bump/answers/Replies.h>

#include <grader/tasks/bump/questions/Numbers.h>

#include <array>

namespace ticker::tasks::bump {
namespace {

/// How the tangents of the two axes make a tilt.
enum class Form {
    direct,        ///< B_u P_u and B_v P_v
    crossProducts  ///< B_u (n x P_v) and B_v (n x P_u), with the signs that fit
};

/// The angles from which the code computes its tangents, relative to the point's own.
struct Angles {
    double turn = 0.0;        ///< added to the longitude
    double polarTimes = 1.0;  ///< factor of the polar angle
};

/// The tangents at those angles.
struct Tangents {
    Vector3 alongU;
    Vector3 alongV;
};

Tangents tangentsOf(const Reply& reply, const Parametrisation& parametrisation,
                    const Angles& angles) {
    const Vector3& axis = parametrisation.axis();
    const Vector3& n = reply.direction;
    const Vector3 outwards = (n - axis * n.dot(axis)).normalised();
    const Vector3 right = outwards.cross(axis);
    const Vector3 turned = outwards * std::cos(angles.turn) + right * std::sin(angles.turn);
    const double polar = angles.polarTimes * std::numbers::pi * reply.v;
    const Vector3 alongU = turned.cross(axis);
    return {parametrisation.mirrored() ? -alongU : alongU,
            turned * std::cos(polar) - axis * std::sin(polar)};
}

/// The direction of the tilt with tangents at those angles.
double angleOf(const Reply& reply, const Parametrisation& parametrisation, const Angles& angles,
               Form form, bool slopeAlongU) {
    const Tangents tangents = tangentsOf(reply, parametrisation, angles);
    const Vector3& n = reply.direction;
    const double sense = parametrisation.mirrored() ? -1.0 : 1.0;
    const Vector3 crossed = slopeAlongU ? tangents.alongV.cross(n) : n.cross(tangents.alongU);
    const Vector3 direct = slopeAlongU ? tangents.alongU : tangents.alongV;
    const Vector3 tilt = form == Form::direct ? direct : crossed * sense;
    return std::atan2(tilt.dot(reply.across), tilt.dot(reply.alongSlope));
}

/// Share of the tilts that `anglesOf(reply)` explains.
template <typename AnglesOf>
double shareExplained(const Replies& replies, const Parametrisation& parametrisation, Form form,
                      AnglesOf anglesOf) {
    double explained = 0.0;
    const auto count = [&](const std::vector<Reply>& asked, bool slopeAlongU) {
        for (const Reply& reply : asked)
            if (near(reply.angle(),
                     angleOf(reply, parametrisation, anglesOf(reply), form, slopeAlongU)))
                explained += 1.0;
    };
    count(replies.onU, true);
    count(replies.onV, false);
    const auto asked = static_cast<double>(replies.onU.size() + replies.onV.size());
    return explained / std::max(1.0, asked);
}

/// Degrees by which the tangents are turned about the axis, if such a turn explains the tilts; 0 if
/// no turn does.
double findTangentTurn(const Replies& replies, const Parametrisation& parametrisation) {
    constexpr int kStep = 10;
    constexpr double kExplained = 0.985;
    for (int turn = 180; turn > -180; turn -= kStep) {
        if (std::abs(turn) < 20) continue;
        for (const Form form : {Form::direct, Form::crossProducts})
            if (shareExplained(replies, parametrisation, form, [turn](const Reply&) {
                    return Angles{turn / kDegrees, 1.0};
                }) >= kExplained)
                return turn;
    }
    return 0.0;
}

/// True if the tangents take sines and cosines of angles in degrees: the longitude, counted from
/// where the student's is 0, and the polar angle both grow 57 times as fast as the point's.
bool areInDegrees(const Replies& replies, const Parametrisation& parametrisation) {
    // Half a texel's uncertainty in u becomes 5 degrees here. Wrong tangents explain a twelfth of
    // the tilts by chance.
    constexpr double kExplained = 0.7;
    constexpr double kFaster = kDegrees - 1.0;
    struct InDegrees {
        bool longitude;
        bool polar;
    };
    for (const double start : {0.5, 0.0, 0.25, 0.75})
        for (const InDegrees angles :
             {InDegrees{true, false}, InDegrees{false, true}, InDegrees{true, true}})
            for (const Form form : {Form::direct, Form::crossProducts}) {
                const auto anglesOf = [&](const Reply& reply) {
                    const double fromStart = 2.0 * std::numbers::pi * (reply.u - start);
                    const double sense = parametrisation.mirrored() ? -1.0 : 1.0;
                    return Angles{angles.longitude ? sense * kFaster * fromStart : 0.0,
                                  angles.polar ? kDegrees : 1.0};
                };
                if (shareExplained(replies, parametrisation, form, anglesOf) >= kExplained)
                    return true;
            }
    return false;
}

}  // namespace

void explainTangents(const Replies& replies, const Parametrisation& parametrisation,
                     Response& response) {
    response.tangentTurn = findTangentTurn(replies, parametrisation);
    response.tangentsInDegrees =
        response.tangentTurn == 0.0 && areInDegrees(replies, parametrisation);
}

}  // namespace ticker::tasks::bump
