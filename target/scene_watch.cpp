#include "target/scene_watch.hpp"

#include <sys/stat.h>

#include "platform/files/file_byte_source.hpp"
#include "render_core/base/float_environment.hpp"

namespace tedavis::target {
namespace {

constexpr long kNanosecondsPerMillisecond = 1'000'000, kNanosecondsPerSecond = 1'000'000'000;

std::timespec after_ms(std::uint32_t ms) {
    std::timespec time{};
    clock_gettime(CLOCK_REALTIME, &time);
    time.tv_sec += ms / 1000;
    time.tv_nsec += static_cast<long>(ms % 1000) * kNanosecondsPerMillisecond;
    if (time.tv_nsec >= kNanosecondsPerSecond) {
        ++time.tv_sec;
        time.tv_nsec -= kNanosecondsPerSecond;
    }
    return time;
}

}  // namespace

bool SceneWatch::start(const char* path, base::Arena& room, std::uint64_t shown, std::uint32_t period_ms) {
    path_ = path;
    room_ = &room;
    shown_ = shown;
    period_ms_ = period_ms;
    is_running_ = pthread_create(&thread_, nullptr, &SceneWatch::thread_main, this) == 0;
    return is_running_;
}

void SceneWatch::await_first_look() {
    if (!is_running_) return;
    pthread_mutex_lock(&mutex_);
    while (!has_looked_) pthread_cond_wait(&looked_, &mutex_);
    pthread_mutex_unlock(&mutex_);
}

void SceneWatch::stop() {
    if (!is_running_) return;
    pthread_mutex_lock(&mutex_);
    is_stopping_ = true;
    pthread_cond_signal(&wake_);
    pthread_mutex_unlock(&mutex_);
    pthread_join(thread_, nullptr);
    is_running_ = false;
}

const scene::Scene* SceneWatch::loaded() {
    pthread_mutex_lock(&mutex_);
    const bool is_loaded = is_loaded_;
    pthread_mutex_unlock(&mutex_);
    return is_loaded ? &scene_ : nullptr;
}

void SceneWatch::go_on(base::Arena& room, std::uint64_t shown) {
    pthread_mutex_lock(&mutex_);
    room_ = &room;
    shown_ = shown;
    is_loaded_ = false;
    pthread_mutex_unlock(&mutex_);
}

base::FixedString<383> SceneWatch::take_fault() {
    pthread_mutex_lock(&mutex_);
    const base::FixedString<383> fault = fault_;
    fault_.clear();
    pthread_mutex_unlock(&mutex_);
    return fault;
}

void* SceneWatch::thread_main(void* self) {
    static_cast<SceneWatch*>(self)->serve();
    return nullptr;
}

void SceneWatch::serve() {
    base::set_float_environment();
    pthread_mutex_lock(&mutex_);
    while (!is_stopping_) {
        if (!is_loaded_) {
            pthread_mutex_unlock(&mutex_);
            look();
            pthread_mutex_lock(&mutex_);
            has_looked_ = true;
            pthread_cond_signal(&looked_);
        }
        const std::timespec next = after_ms(period_ms_);
        if (!is_stopping_) pthread_cond_timedwait(&wake_, &mutex_, &next);
    }
    pthread_mutex_unlock(&mutex_);
}

bool SceneWatch::are_alike(const Stamp& a, const Stamp& b) {
    return a.inode == b.inode && a.bytes == b.bytes && a.changed.tv_sec == b.changed.tv_sec &&
           a.changed.tv_nsec == b.changed.tv_nsec;
}

/// A file that is not there may come, and is spoken of once, at the start.
void SceneWatch::look() {
    struct stat status {};
    const bool is_there = stat(path_, &status) == 0, is_first = is_first_look_;
    is_first_look_ = false;
    if (!is_there && is_first) refuse("is not there yet");
    if (!is_there) return;
    const Stamp stamp{status.st_ino, status.st_size, status.st_mtim};
    if (are_alike(stamp, seen_)) return;
    seen_ = stamp;
    auto file = platform::open_file(path_);
    if (!file.ok()) return refuse(file.error().message.view());
    room_->reset();
    const auto read = scene::Scene::load(file.value(), *room_);
    if (!read.ok()) return refuse(scene::describe(read.error()).view());
    if (read.value().header().revision <= shown_) return;
    pthread_mutex_lock(&mutex_);
    scene_ = read.value();
    is_loaded_ = true;
    pthread_mutex_unlock(&mutex_);
}

void SceneWatch::refuse(std::string_view what) {
    pthread_mutex_lock(&mutex_);
    fault_ = base::FixedString<383>(path_);
    fault_.append(": ");
    fault_.append(what);
    fault_.append(shown_ == 0 ? "; there are no data until a sound scene is in its place" : "; the scene that is shown stays");
    pthread_mutex_unlock(&mutex_);
}

}  // namespace tedavis::target
