#include "target/snapshot.hpp"

#include <new>
#include <string_view>

#include "render_core/gl/readback.hpp"
#include "target/new_file.hpp"
#include "target/png_picture.hpp"

namespace tedavis::target {
namespace {

volatile sig_atomic_t picture_asked_for = 0;

void ask_for_picture(int) { picture_asked_for = 1; }

}  // namespace

Snapshot::~Snapshot() {
    if (is_started()) sigaction(SIGUSR1, &previous_, nullptr);
}

base::Error Snapshot::start(const char* path, std::uint32_t width_px, std::uint32_t height_px) {
    NewFile trial;
    if (base::Error error = trial.open(path)) return error;
    width_px_ = width_px;
    height_px_ = height_px;
    pixel_bytes_ = std::size_t{4} * width_px * height_px;
    file_bytes_ = png_bytes(width_px, height_px);
    pixels_.reset(new (std::nothrow) std::uint8_t[pixel_bytes_]);
    file_.reset(new (std::nothrow) std::uint8_t[file_bytes_]);
    if (pixels_ == nullptr || file_ == nullptr) return base::make_error("--shot: no memory for a picture; free some");
    path_ = path;
    picture_asked_for = 0;
    struct sigaction action {};
    action.sa_handler = &ask_for_picture;
    sigemptyset(&action.sa_mask);
    sigaction(SIGUSR1, &action, &previous_);
    return {};
}

bool Snapshot::take_request() {
    if (picture_asked_for == 0) return false;
    picture_asked_for = 0;
    return true;
}

void Snapshot::take(gl::Gl& gl) {
    if (!gl::read_pixels(gl, width_px_, height_px_, {pixels_.get(), pixel_bytes_})) {
        log_.write({path_, ": is not written, for the driver did not give the pixels; try it again"});
        return;
    }
    write_png(width_px_, height_px_, {pixels_.get(), pixel_bytes_}, {file_.get(), file_bytes_});
    NewFile file;
    base::Error error = file.open(path_);
    if (!error) error = file.write({reinterpret_cast<const char*>(file_.get()), file_bytes_});
    log_.write({error ? error.message.view() : path_, error ? "" : ": is the picture of this moment"});
}

}  // namespace tedavis::target
