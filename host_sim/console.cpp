#include "host_sim/console.hpp"

namespace tedavis::host_sim {

void Console::result(std::string_view text, std::string_view json) {
    progress_done();
    if (results_ != nullptr) write_line(*results_, json_ ? json : text);
}

Console Console::without_result() const {
    Console same = *this;
    same.results_ = nullptr;
    return same;
}

void Console::note(std::string_view sentence) {
    progress_done();
    write_line(*notes_, sentence);
}

void Console::progress(std::string_view what, std::uint64_t done, std::uint64_t total) {
    if (!live_ || total == 0) return;
    const int percent = static_cast<int>(static_cast<double>(done) * 100.0 / static_cast<double>(total));
    if (percent == shown_percent_) return;
    shown_percent_ = percent;
    *notes_ << '\r' << what << ' ' << percent << " %" << std::flush;
}

void Console::progress_done() {
    if (shown_percent_ < 0) return;
    shown_percent_ = -1;
    *notes_ << '\n' << std::flush;
}

void Console::write_line(std::ostream& stream, std::string_view text) {
    stream << text;
    if (text.empty() || text.back() != '\n') stream << '\n';
    stream << std::flush;
}

}  // namespace tedavis::host_sim
