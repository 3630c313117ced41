// Plain data as bytes and back, from one description of it, so that saving and loading cannot drift apart:
//
//   void describe(Archive& archive, Progress& progress) { archive(progress.step, progress.forces); }
//
// Numbers are kept bit for bit, little-endian. The file: the text "bondstatic NAME\n", the version (4 bytes),
// the size of the content and its checksum (8 bytes each), the content. Text and vectors begin with their
// length in 8 bytes.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <vector>

#include "bondstatic/types.hpp"
#include "io/checksum.hpp"

namespace bondstatic {

static_assert(std::endian::native == std::endian::little, "archives are little-endian");

struct ArchiveFormat {
  std::string name;  ///< what messages call it: "checkpoint"
  std::uint32_t version;
};

/// Whether the bytes of a T are its value, so that whole vectors of it can be copied at once.
template <class T>
struct IsFlat : std::bool_constant<std::is_integral_v<T> || std::is_same_v<T, float> ||
                                   std::is_same_v<T, double> || std::is_enum_v<T>> {};
template <>
struct IsFlat<bool> : std::false_type {};  // other bytes than 0 and 1 must not get in
template <class T, std::size_t n>
struct IsFlat<std::array<T, n>> : std::bool_constant<IsFlat<T>::value && (n > 0)> {};
template <class T, int rows, int columns, int options>
struct IsFlat<Eigen::Matrix<T, rows, columns, options, rows, columns>>
    : std::bool_constant<IsFlat<T>::value && (rows > 0) && (columns > 0)> {};

class Archive {
 public:
  /// For writing.
  explicit Archive(const ArchiveFormat& format);
  /// For reading `file`, which must outlive the archive; `shown` is its name in messages. Throws Error
  /// (invalid_input) where it is not of this format or is damaged; the content is only read after that.
  Archive(const ArchiveFormat& format, std::string_view file, std::string shown);
  /// For a checksum only.
  Archive() = default;

  bool reading() const { return mode_ == Mode::reading; }

  /// Numbers, enums, text, vectors and arrays, Eigen's of fixed size, optional values, and what has a
  /// `describe` as above, in any nesting. Constants are fine where nothing is read into them.
  template <class... T>
  Archive& operator()(T&... values) {
    (value(values), ...);
    return *this;
  }
  template <class T>
  void value(T& data);

  /// The whole file; ends the writing.
  std::string finish();
  /// Throws Error (invalid_input) where something is left to read.
  void expect_end() const;
  std::uint64_t checksum() const { return checksum_.value(); }

 private:
  enum class Mode { hashing, writing, reading };

  void bytes(void* data, std::size_t size);
  /// Writes or reads the length of a sequence whose elements take `least` bytes or more.
  std::size_t length(std::size_t size, std::size_t least);
  [[noreturn]] void damaged(const std::string& reason) const;
  std::size_t header_size() const;

  template <class T>
  void sequence(T& values);

  Mode mode_ = Mode::hashing;
  ArchiveFormat format_{};
  std::string written_;
  std::string_view left_;
  std::string shown_;
  Checksum checksum_;
};

/// A number that tells whether the data are still the same.
template <class... T>
std::uint64_t fingerprint(const T&... values) {
  return Archive()(values...).checksum();
}

template <class T>
void Archive::value(T& data) {
  if constexpr (std::is_const_v<T>) {
    if (reading()) throw std::logic_error("archive: cannot read into a constant");
    this->value(const_cast<std::remove_const_t<T>&>(data));  // only looked at, outside of reading
  } else if constexpr (IsFlat<T>::value) {
    bytes(&data, sizeof data);
  } else if constexpr (std::is_same_v<T, bool>) {
    std::uint8_t byte = data;
    bytes(&byte, 1);
    if (reading()) data = byte != 0;
  } else if constexpr (requires { data.has_value(); }) {
    bool there = data.has_value();
    this->value(there);
    if (reading()) there ? void(data.emplace()) : data.reset();
    if (there) this->value(*data);
  } else if constexpr (requires { data.push_back(data.front()); }) {
    sequence(data);
  } else if constexpr (requires { std::tuple_size<T>::value; }) {
    for (auto& element : data) this->value(element);
  } else {
    describe(*this, data);
  }
}

template <class T>
void Archive::sequence(T& values) {
  using Element = typename T::value_type;
  constexpr bool flat = IsFlat<Element>::value;
  const std::size_t size = length(values.size(), flat ? sizeof(Element) : 1);
  if constexpr (flat) {
    if (reading()) values.resize(size);
    bytes(values.data(), size * sizeof(Element));
  } else {
    // Grows as it is read: an element may be much larger than what stands for it in the file.
    if (reading()) values.clear();
    for (std::size_t i = 0; i < size; ++i) {
      if (reading()) values.emplace_back();
      if constexpr (std::is_same_v<Element, bool>) {
        bool element = values[i];
        value(element);
        if (reading()) values[i] = element;
      } else {
        value(values[i]);
      }
    }
  }
}

}  // namespace bondstatic
