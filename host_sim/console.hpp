/// The output of a command: its result on stdout (text, or JSON with --json), notes and progress on stderr.
#pragma once

#include <chrono>
#include <cstdint>
#include <istream>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>

namespace tedavis::host_sim {

class Console {
public:
    static constexpr std::chrono::milliseconds kBetweenLines{5000};

    /// The streams must outlive the console. `live` says that `notes` is a terminal: then progress is one line that is redrawn,
    /// else a line every few seconds.
    Console(std::ostream& results, std::ostream& notes, bool json, bool live)
        : results_(&results), notes_(&notes), json_(json), live_(live) {}

    /// The command's result, once: `json` with --json, else `text`; a missing line end is added.
    void result(std::string_view text, std::string_view json);
    /// One sentence beside the result.
    void note(std::string_view message);
    /// Shows progress. On a terminal one line is redrawn on every new percent and once a second, with the time left once it can
    /// be estimated; elsewhere a line is printed after each `between_lines` of work. A new `what` begins a new piece of work.
    void progress(std::string_view what, std::uint64_t done, std::uint64_t total);
    /// Ends the progress line, so that what follows starts on its own.
    void progress_done();

    /// Returns a console with the same output except the result, for a command that is a part of another one.
    [[nodiscard]] Console without_result() const;

    /// Sets the stream of the user's answers, which must outlive the console; null: there is no user.
    void set_answers(std::istream* answers) { answers_ = answers; }
    void set_between_lines(std::chrono::milliseconds between_lines) { between_lines_ = between_lines; }
    /// Asks a question and waits: true for an answer that begins with y, else false, also at the end of the input. Nothing where
    /// there is no user.
    [[nodiscard]] std::optional<bool> confirm(std::string_view question);

    [[nodiscard]] bool json() const { return json_; }

private:
    void write_line(std::ostream& stream, std::string_view text);
    void redraw(const std::string& line);

    std::ostream* results_;  ///< null: the result is not printed
    std::ostream* notes_;
    std::istream* answers_ = nullptr;
    std::chrono::milliseconds between_lines_ = kBetweenLines;
    bool json_;
    bool live_;
    int shown_percent_ = -1;
    std::string shown_what_;
    std::size_t shown_length_ = 0;
    std::chrono::steady_clock::time_point begun_, drawn_;
};

}  // namespace tedavis::host_sim
