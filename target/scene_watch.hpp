/// Watches a scene database and loads a newer one beside the one that is shown, on a thread of its own.
///
/// A file counts when it is another one than was looked at before (inode, size or time of change), whole, and of a larger
/// revision. Whoever writes it must rename a finished file into place, as `tedavis scene build` does. While a loaded scene waits
/// to be taken over the thread looks at nothing. A file that is not sound is said once, and the scene that is shown stays; so is
/// one that is not there at the start.
///
/// Memory    the arena that it is lent; nothing else after start(). Thread  all calls from one; its own does the reading.
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

    /// `path` and `room` must stay until stop(). `shown`: the revision that is shown, 0 for none. False where the machine gives
    /// no thread. Looks every `period_ms`.
    [[nodiscard]] bool start(const char* path, base::Arena& room, std::uint64_t shown, std::uint32_t period_ms = 1000);
    void stop();

    /// A newer scene in the room, or null. It stays until go_on().
    [[nodiscard]] const scene::Scene* loaded();
    /// After loaded() has given one: the next scene is loaded into `room`.
    void go_on(base::Arena& room, std::uint64_t shown);
    /// What was wrong with a file, once; empty for nothing new.
    [[nodiscard]] base::FixedString<383> take_fault();

private:
    /// What tells files apart.
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
    pthread_cond_t wake_ = PTHREAD_COND_INITIALIZER;
    pthread_t thread_{};
    std::uint32_t period_ms_ = 0;
    bool is_running_ = false, is_stopping_ = false;
    // Of the thread alone while there is no loaded scene, of the owner else.
    base::Arena* room_ = nullptr;
    std::uint64_t shown_ = 0;
    scene::Scene scene_;
    bool is_loaded_ = false, is_first_look_ = true;
    Stamp seen_;
    base::FixedString<383> fault_;
};

}  // namespace tedavis::target
