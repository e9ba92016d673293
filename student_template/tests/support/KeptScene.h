#ifndef SUPPORT_KEPTSCENE_H
#define SUPPORT_KEPTSCENE_H

#include <raytracer/scene/Scene.h>

#include <deque>

namespace raytracer::tests {

/// A scene that stays until the tests have ended, so that no other one gets its address: a solution
/// may keep values by the address of a scene or an object. A program has one scene.
inline const Scene& keptScene(const SceneDescription& description,
                              RenderObserver* observer = nullptr) {
    static std::deque<Scene> scenes;
    return scenes.emplace_back(description, observer);
}

}  // namespace raytracer::tests

#endif
