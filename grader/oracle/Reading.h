#ifndef TICKER_ORACLE_READING_H
#define TICKER_ORACLE_READING_H

namespace ticker::oracle {

/// How the aim points of shadow rays lie around a light's centre.
/// The first four are accepted (docs/decisions/0003), the others are mistakes.
enum class LightShape {
    ball,           ///< uniform in the ball of radius lightSize
    surface,        ///< uniform on its surface
    uniformRadius,  ///< direction uniform, radius uniform
    polarHelper,    ///< the original's helper: radius, polar angle and azimuth each uniform
    cube,           ///< uniform in the cube of half-width lightSize
    disc,           ///< uniform in the disc of radius lightSize in the xy-plane
    halfBall,       ///< the upper half (y > 0) of the ball
    centre          ///< always the centre: hard shadows
};

/// How far an object may be and still cast a shadow.
enum class ShadowReach {
    toSample,  ///< nearer than the aim point (reference solution)
    toCentre,  ///< nearer than the light's centre: accepted
    endless    ///< mistake: objects behind the light cast shadows, too
};

/// Which directions the Phong terms use.
enum class PhongReading {
    central,            ///< to the light's centre, times the share of rays that arrive (reference)
    perSample,          ///< direction and distance of every aim point that is reached: accepted
    perSampleDirection  ///< direction of every aim point, distance of the centre: accepted
};

/// How a bumpy sphere reads its height map (docs/decisions/0003). The defaults are the reference's.
struct BumpReading {
    enum class Lookup { nearest, bilinear };
    enum class Difference { forward, backward, central };
    enum class LatitudeGain { constant, sine, inverseSine };

    Lookup lookup = Lookup::nearest;
    Difference difference = Difference::forward;
    LatitudeGain longitudeGain = LatitudeGain::constant;  ///< of the tilt along u
    double uOrigin = 0.5;   ///< u of the point that faces the eye (-z); 0.75 is common
    bool mirrored = false;  ///< u runs to the left
    double gainU = 1.0;     ///< scales the slope along u; negative: inverted (a mistake)
    double gainV = 1.0;     ///< likewise along v
    bool swapped = false;   ///< each slope tilts along the other's tangent (a mistake)
};

/// One way to read the handout. The defaults are the reference solution's. The fields before
/// `bump`, and those of `bump` not marked as mistakes, span the accepted readings
/// (docs/decisions/0003).
struct Reading {
    double apertureFactor = 1.0;  ///< half-width of the lens / dofAmount: 1 or 0.5 are accepted
    /// Side of the square on the focal plane that the rays of a pixel pass through, uniformly, in
    /// pixels. Values above 0 (antialiasing) up to 1 are accepted, too.
    double pixelSpread = 0.0;
    LightShape lightShape = LightShape::ball;
    ShadowReach shadowReach = ShadowReach::toSample;
    PhongReading phong = PhongReading::central;
    bool viewerIsEye = false;     ///< V towards the origin of the world instead of the ray's origin
    double shadowBias = 1e-4;     ///< world units, 1e-6 to 1e-3 accepted
    bool biasAlongLight = false;  ///< start of a shadow ray moved along L instead of N
    BumpReading bump;
};

/// Mistakes that students make, as parameters; the defaults make none. They combine freely, but
/// allOrNothing, litIfAny and pointJitter work with PhongReading::central only.
struct Mistake {
    double lightSizeFactor = 1.0;  ///< radius of the light / lightSize
    double lightOffset[3] = {};    ///< aim points moved, in units of lightSize (off-centre)
    bool shadowInverted = false;   ///< lit and shadowed exchanged
    bool allOrNothing = false;     ///< lit only where every ray arrives (integer division)
    bool litIfAny = false;         ///< lit where at least one ray arrives
    bool ambientScaled = false;    ///< the ambient term is scaled by each light's share, too
    bool specularUnshadowed = false;
    bool diffuseUnshadowed = false;
    bool lightsMixed = false;      ///< sums shared between lights: earlier lights count again
    double pointJitter = 0.0;      ///< start of shadow rays moved by a ball point times this
    bool directionOffset = false;  ///< ball point * lightSize added to the unit direction

    enum class Aperture { square, disc, none, horizontal, diagonal };
    Aperture aperture = Aperture::square;
    double lensOffsetX = 0.0;  ///< in half-widths: 1 with apertureFactor 0.5: [0, dofAmount]
    double lensOffsetY = 0.0;
    bool focalByDistance = false;    ///< focal point at dofFocalPlane along the ray, not in z
    double focalFactor = 1.0;        ///< focal plane's z / dofFocalPlane
    bool lensSharedByFrame = false;  ///< one lens point for the whole picture (students only)
    double pixelScale = 1.0;         ///< the pixel times this: dofRayCount for a forgotten division
};

/// Optimisations of the oracle beyond SIMD. None changes an expected value; each can be switched
/// off to prove that.
struct Tricks {
    /// Points that no object can shade, or that one sphere shades completely, draw no shadow
    /// samples: decided by cones around light and occluder (J. Amanatides, "Ray Tracing with
    /// Cones", SIGGRAPH 1984).
    bool coneTests = true;
    /// Randomly shifted lattice points for means, see Lattice.h; off: plain random points.
    bool lowDiscrepancy = true;
    /// For means, the share of a ball that one sphere or one plane hides is computed in closed form
    /// or by a short quadrature instead of by samples.
    bool closedForms = true;
    /// Two shadow rays a hit instead of shadowRayCount, for means and variances: the second moment
    /// follows from the products of two independent estimates.
    bool pairedShadows = true;
    /// Each pixel gets as many lens paths as its own noise requires (J. Neyman, "On the Two
    /// Different Aspects of the Representative Method", 1934), estimated by a pilot whose samples
    /// are discarded.
    bool allocation = true;
};

}  // namespace ticker::oracle

#endif
