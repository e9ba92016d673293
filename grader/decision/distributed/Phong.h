#ifndef TICKER_DECISION_DISTRIBUTED_PHONG_H
#define TICKER_DECISION_DISTRIBUTED_PHONG_H

#include <questions/RayGeometry.h>

namespace ticker::decision {

using raytracer::ColourRGB;
using raytracer::Vector3;
using raytracer::questions::phongTerms;
using raytracer::questions::PhongTerms;

}  // namespace ticker::decision

#endif
