// What a submission's file is likely to include, compiled ahead: only speed depends on it. Where a
// file does not compile with it, it is compiled again without.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>
