#ifndef TICKER_TASKS_SHADOWS_ANSWERS_PHONG_H
#define TICKER_TASKS_SHADOWS_ANSWERS_PHONG_H

#include <questions/RayGeometry.h>

namespace ticker::tasks {

using raytracer::ColourRGB;
using raytracer::Vector3;
using raytracer::questions::phongTerms;
using raytracer::questions::PhongTerms;

}  // namespace ticker::tasks

#endif
