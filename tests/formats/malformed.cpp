#include "formats/malformed.hpp"

#include <gtest/gtest.h>

#include <random>

namespace bondstatic::test {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size() - 1);
    lines.push_back(text.substr(begin, end + 1 - begin));
    begin = end + 1;
  }
  return lines;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line;
  return text;
}

std::string with_crlf(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '\n') out += '\r';
    out += c;
  }
  return out;
}

struct Span {
  std::size_t begin, size;
};

std::vector<Span> fields_of(const std::string& text) {
  std::vector<Span> fields;
  const char* separators = " \t\n,;";
  for (std::size_t at = text.find_first_not_of(separators); at != std::string::npos;) {
    const std::size_t end = std::min(text.find_first_of(separators, at), text.size());
    fields.push_back({at, end - at});
    at = text.find_first_not_of(separators, end);
  }
  return fields;
}

void add_replaced_fields(const std::string& text, std::mt19937& random, std::vector<Damage>& out) {
  const std::vector<Span> fields = fields_of(text);
  const std::vector<std::string> values{"nan",
                                        "-nan",
                                        "inf",
                                        "1e400",
                                        "-1e400",
                                        "-1",
                                        "0",
                                        "1e-400",
                                        "9223372036854775808",
                                        "99999999",
                                        "word",
                                        "1.5.2",
                                        "0x10",
                                        "1,5",
                                        "",
                                        "-9223372036854775808",
                                        "\x80\xff"};
  for (const std::string& value : values)
    for (int repeat = 0; repeat < 12; ++repeat) {
      const Span field = fields[random() % fields.size()];
      std::string changed = text;
      changed.replace(field.begin, field.size, value);
      out.push_back({"\"" + value + "\" at byte " + std::to_string(field.begin), changed});
    }
}

void add_moved_lines(const std::string& text, std::mt19937& random, std::vector<Damage>& out) {
  const std::vector<std::string> lines = lines_of(text);
  for (int repeat = 0; repeat < 20; ++repeat) {
    const std::size_t i = random() % lines.size(), j = random() % lines.size();
    std::vector<std::string> swapped = lines, doubled = lines, shorter = lines;
    std::swap(swapped[i], swapped[j]);
    doubled.insert(doubled.begin() + long(j), lines[i]);
    shorter.erase(shorter.begin() + long(i));
    const std::string which = std::to_string(i + 1) + ", " + std::to_string(j + 1);
    out.push_back({"lines swapped: " + which, joined(swapped)});
    out.push_back({"line doubled: " + which, joined(doubled)});
    out.push_back({"line left out: " + which, joined(shorter)});
  }
}

std::string garbage(std::size_t size, std::mt19937& random) {
  std::string bytes;
  for (std::size_t i = 0; i < size; ++i) bytes += char(random() % 256);
  return bytes;
}

}  // namespace

std::vector<Damage> truncations(const std::string& text) {
  std::mt19937 random(1);
  std::vector<Damage> out;
  for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 1))
    if (at + 1 < text.size()) out.push_back({"cut after byte " + std::to_string(at), text.substr(0, at + 1)});
  for (int i = 0; i < 60; ++i) {
    const std::size_t at = random() % text.size();
    out.push_back({"cut at byte " + std::to_string(at), text.substr(0, at)});
  }
  out.push_back({"empty", ""});
  return out;
}

std::vector<Damage> damages(const std::string& text) {
  std::mt19937 random(2);
  std::vector<Damage> out;
  add_replaced_fields(text, random, out);
  add_moved_lines(text, random, out);
  for (int i = 0; i < 8; ++i) {
    std::string changed = text;
    changed[random() % text.size()] = '\0';
    out.push_back({"NUL", changed});
    changed = text;
    changed.insert(random() % text.size(), garbage(40, random));
    out.push_back({"garbage within", changed});
  }
  out.push_back({"garbage only", garbage(5000, random)});
  const std::size_t middle = text.find('\n', text.size() / 2);
  out.push_back(
      {"a line of 10 MB", text.substr(0, middle) + std::string(10'000'000, '7') + text.substr(middle)});
  out.push_back({"a line of 10 MB at the end", text + std::string(10'000'000, ' ')});
  return out;
}

Answer read_damaged(const DigestingReader& reader, const std::string& text, const std::string& name) {
  const ScratchFolder folder;
  Answer answer;
  answer.digest = reader(folder.write("file", text), answer.faults);
  EXPECT_NE(answer.digest.has_value(), !answer.faults.empty())
      << name << ": both or neither of result and faults";
  for (const Fault& fault : answer.faults) {
    EXPECT_FALSE(fault.place.file.empty()) << name << ": " << to_string(fault);
    EXPECT_GE(fault.place.line, 1) << name << ": " << to_string(fault);
    EXPECT_GE(fault.place.column, 1) << name << ": " << to_string(fault);
    EXPECT_FALSE(fault.message.empty()) << name << ": " << to_string(fault);
    EXPECT_FALSE(fault.cure.empty()) << name << ": " << to_string(fault);
  }
  return answer;
}

void expect_fault(const DigestingReader& reader, const std::string& text, const std::string& mention,
                  int line) {
  const Answer answer = read_damaged(reader, text, mention);
  EXPECT_FALSE(answer.digest) << "read without a word about \"" << mention << "\"";
  bool found = false;
  std::string all;
  for (const Fault& fault : answer.faults) {
    const bool said = (fault.message + "\n" + fault.cure).find(mention) != std::string::npos;
    found = found || (said && (line == 0 || fault.place.line == line));
    all += to_string(fault) + "\n";
  }
  EXPECT_TRUE(found) << "no fault says \"" << mention << "\" in line " << line << ":\n" << all;
}

void expect_robust(const DigestingReader& reader, const std::string& text) {
  const Answer sound = read_damaged(reader, text, "sound");
  ASSERT_TRUE(sound.digest) << (sound.faults.empty() ? "" : to_string(sound.faults.front()));
  EXPECT_EQ(read_damaged(reader, with_crlf(text), "CRLF").digest, sound.digest);
  EXPECT_EQ(read_damaged(reader, "\xEF\xBB\xBF" + text, "byte order mark").digest, sound.digest);
  for (const Damage& damage : truncations(text)) read_damaged(reader, damage.text, damage.name);
  for (const Damage& damage : damages(text)) read_damaged(reader, damage.text, damage.name);
}

}  // namespace bondstatic::test
