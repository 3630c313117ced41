#include "report/html.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <thread>

#include "report/page_json.hpp"

namespace bondstatic {

std::string html(const PageData& data, const Blocks& blocks, const PageBundle& page) {
  std::string text(html_head);
  const auto into = std::back_inserter(text);
  fmt::format_to(into,
                 "<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                 "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; "
                 "script-src '{}'; style-src 'unsafe-inline'; img-src data: blob:; base-uri 'none'; "
                 "form-action 'none'\">\n"
                 "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
                 "<meta name=\"generator\" content=\"bondstatic {}\">\n"
                 "<link rel=\"icon\" href=\"data:,\">\n"
                 "<title>bondstatic report</title>\n<style>{}</style>\n</head>\n<body>\n"
                 "<noscript><p>This report is drawn by a script that lies in the file itself: allow "
                 "JavaScript for it.</p></noscript>\n",
                 page.script_hash, data.version, page.style);
  fmt::format_to(into, "<script type=\"application/json\" id=\"page-data\">{}</script>\n", page_json(data));
  const int threads = int(std::max(1u, std::thread::hardware_concurrency()));
  const std::vector<std::string> numbers = blocks.texts(threads);
  for (std::size_t i = 0; i < numbers.size(); ++i)
    fmt::format_to(into, "<script type=\"text/plain\" id=\"block-{}\">{}</script>\n", i, numbers[i]);
  fmt::format_to(into, "<script>{}</script>\n</body>\n</html>\n", page.script);
  return text;
}

}  // namespace bondstatic
