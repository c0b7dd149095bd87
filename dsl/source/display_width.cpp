// Header: dsl/source/display_width.hpp. Test: tests/dsl/source/render_test.cpp.
// SPDX-License-Identifier: MIT
#include "dsl/source/display_width.hpp"

#include <clocale> // newlocale and uselocale too: these are POSIX
#include <cwchar>

namespace director::dsl {

namespace {

const locale_t no_locale{};

locale_t utf8_locale() {
  static const locale_t made = newlocale(LC_CTYPE_MASK, "C.UTF-8", no_locale);
  return made;
}

/// Sets the locale of this thread only, and only during its lifetime: nothing else that the program prints depends on a
/// locale.
class InLocale {
public:
  explicit InLocale(locale_t locale) : before_(uselocale(locale)) {}
  ~InLocale() { uselocale(before_); }
  InLocale(const InLocale&) = delete;
  InLocale& operator=(const InLocale&) = delete;

private:
  locale_t before_;
};

} // namespace

Glyph glyph_at(std::string_view text, std::size_t at) {
  const auto first = static_cast<unsigned char>(text[at]);
  if (first < 0x80) return {1, 1, first >= 0x20 && first != 0x7F};
  Glyph out;
  if (utf8_locale() == no_locale) {
    while (at + out.bytes < text.size() && continues_character(text[at + out.bytes])) ++out.bytes;
    return out;
  }
  const InLocale scope(utf8_locale());
  wchar_t character = 0;
  std::mbstate_t state{};
  const std::size_t bytes = std::mbrtowc(&character, text.data() + at, text.size() - at, &state);
  if (bytes == 0 || bytes > text.size() - at) return {1, 1, false}; // not UTF-8
  const int columns = wcwidth(character);
  const bool control = character < 0xA0; // U+0080 to U+009F; what is merely unknown to this C library may be shown
  return {bytes, columns < 0 ? 1 : static_cast<std::size_t>(columns), !control};
}

} // namespace director::dsl
