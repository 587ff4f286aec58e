/// Watches a scene database and loads a newer revision beside the scene in use, on its own thread.
///
/// A file is loaded when it differs from the last one examined (inode, size or time of change), is complete, and has a larger
/// revision. The writer must rename a finished file into place, as `tedavis scene build` does. The thread examines no file
/// while a loaded scene has not been taken over. A damaged file, or a missing one at start, is reported once, and the scene in
/// use stays.
///
/// Memory    the arena that the caller lends; nothing else after start(). Thread  all calls from one thread; the object's own
/// thread reads the file.
#pragma once

#include <pthread.h>
#include <sys/types.h>

#include <cstdint>
#include <ctime>

#include "render_core/base/error.hpp"
#include "render_core/base/fixed_string.hpp"
#include "render_core/scene/scene.hpp"

namespace tedavis::target {

class SceneWatch {
public:
    SceneWatch() = default;
    ~SceneWatch() { stop(); }
    SceneWatch(const SceneWatch&) = delete;
    SceneWatch& operator=(const SceneWatch&) = delete;

    /// Examines the file every `period_ms`. `path` and `room` must stay valid until stop(). `shown` is the revision in use, 0
    /// for none. Returns false where the thread cannot be created.
    [[nodiscard]] bool start(const char* path, base::Arena& room, std::uint64_t shown, std::uint32_t period_ms = 1000);
    /// Waits until the file was looked at for the first time.
    void await_first_look();
    void stop();

    /// Returns a newer scene, which lies in `room`, or null. It stays valid until go_on().
    [[nodiscard]] const scene::Scene* loaded();
    /// To be called after loaded() has returned a scene: the next one is loaded into `room`.
    void go_on(base::Arena& room, std::uint64_t shown);
    /// Returns a fault of a file once; empty where there is no new one.
    [[nodiscard]] base::FixedString<383> take_fault();

private:
    /// Identifies a version of the file.
    struct Stamp {
        ino_t inode = 0;
        off_t bytes = 0;
        std::timespec changed{};
    };
    [[nodiscard]] static bool are_alike(const Stamp& a, const Stamp& b);
    static void* thread_main(void* self);
    void serve();
    void look();
    void refuse(std::string_view what);

    const char* path_ = "";
    pthread_mutex_t mutex_ = PTHREAD_MUTEX_INITIALIZER;
    pthread_cond_t wake_ = PTHREAD_COND_INITIALIZER, looked_ = PTHREAD_COND_INITIALIZER;
    pthread_t thread_{};
    std::uint32_t period_ms_ = 0;
    bool is_running_ = false, is_stopping_ = false;
    // Accessed by the thread only while no scene is loaded, otherwise by the owner only.
    base::Arena* room_ = nullptr;
    std::uint64_t shown_ = 0;
    scene::Scene scene_;
    bool is_loaded_ = false, is_first_look_ = true, has_looked_ = false;
    Stamp seen_;
    base::FixedString<383> fault_;
};

}  // namespace tedavis::target
