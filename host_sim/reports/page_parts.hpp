/// The common parts of the pages of runs: style, sections, tables and figures. Each page is self-contained: pictures are data
/// URIs, and there are no scripts and no network requests.
#pragma once

#include <string>

namespace tedavis::host_sim {

/// A whole document; `title` is text, `body` HTML.
[[nodiscard]] std::string html_page(const std::string& title, const std::string& body, const std::string& more_style = {});
/// With a heading of the second level; both are HTML.
[[nodiscard]] std::string page_section(const std::string& title, const std::string& content);
/// `head` and `rows` are HTML; wide tables scroll by themselves.
[[nodiscard]] std::string page_table(const std::string& head, const std::string& rows);
/// A cell of text.
[[nodiscard]] std::string text_cell(const std::string& text);
/// A cell of a number, HTML, aligned to the right.
[[nodiscard]] std::string number_cell(const std::string& html);
/// A picture, given as the bytes of a PNG file, over its caption, a text. `kind`: a class of the page's style.
[[nodiscard]] std::string page_figure(const std::string& caption, const std::string& png, const std::string& kind = "");
/// Folded away, and not printed; `title` and `content` are HTML.
[[nodiscard]] std::string folded_part(const std::string& title, const std::string& content);

}  // namespace tedavis::host_sim
