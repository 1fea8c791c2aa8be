#include "runtime/render/stroke_font.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>

namespace toile {
namespace {

/// A glyph is drawn on a grid of digits: baseline 2, small letters up to 6, capitals up to 8, descenders down to 0.
/// Mxy goes to a point, Lxy draws a line there, Qabxy a parabola with the control point ab.
struct Glyph {
  char character;
  int width;
  std::string_view path;
};

constexpr std::array kGlyphs{
    Glyph{' ', 1, ""},
    Glyph{'0', 4, "M28Q0805Q0222Q4245Q4828"},
    Glyph{'1', 4, "M17L28L22"},
    Glyph{'2', 4, "M07Q0828Q4846Q4402L42"},
    Glyph{'3', 4, "M07Q0828Q4847Q4525M15L25Q4543Q4222Q0203"},
    Glyph{'4', 4, "M32L38L04L44"},
    Glyph{'5', 4, "M48L08L05L25Q4544L43Q4222Q0203"},
    Glyph{'6', 4, "M47Q4828Q0805L04Q0222Q4244Q4626Q0604"},
    Glyph{'7', 4, "M08L48L12"},
    Glyph{'8', 4, "M25Q0506L07Q0828Q4847L46Q4525M25Q0504L03Q0222Q4243L44Q4525"},
    Glyph{'9', 4, "M03Q0222Q4245L46Q4828Q0806Q0424Q4446"},
    Glyph{'a', 4, "M46L42M44Q4626Q0604Q0222Q4244"},
    Glyph{'b', 4, "M08L02M04Q0626Q4644Q4222Q0204"},
    Glyph{'c', 4, "M45Q4626Q0604Q0222Q4243"},
    Glyph{'d', 4, "M48L42M44Q4626Q0604Q0222Q4244"},
    Glyph{'e', 4, "M04L44Q4626Q0604Q0222Q3243"},
    Glyph{'f', 3, "M38Q1816L12M06L36"},
    Glyph{'g', 4, "M46L42Q4020Q1001M44Q4626Q0604Q0222Q4244"},
    Glyph{'h', 4, "M08L02M04Q0626Q4644L42"},
    Glyph{'i', 0, "M06L02M08"},
    Glyph{'j', 1, "M16L11Q1000M18"},
    Glyph{'k', 3, "M08L02M36L04L32"},
    Glyph{'l', 0, "M08L02"},
    Glyph{'m', 6, "M06L02M04Q0616Q3634L32M34Q3646Q6664L62"},
    Glyph{'n', 4, "M06L02M04Q0626Q4644L42"},
    Glyph{'o', 4, "M26Q0604Q0222Q4244Q4626"},
    Glyph{'p', 4, "M06L00M04Q0626Q4644Q4222Q0204"},
    Glyph{'q', 4, "M46L40M44Q4626Q0604Q0222Q4244"},
    Glyph{'r', 3, "M06L02M04Q0636"},
    Glyph{'s', 4, "M45Q4626Q0605Q0424Q4443Q4222Q0203"},
    Glyph{'t', 3, "M18L13Q1232M06L36"},
    Glyph{'u', 4, "M06L04Q0222Q4244M46L42"},
    Glyph{'v', 4, "M06L22L46"},
    Glyph{'w', 6, "M06L12L36L52L66"},
    Glyph{'x', 4, "M06L42M02L46"},
    Glyph{'y', 4, "M06L22M46L10"},
    Glyph{'z', 4, "M06L46L02L42"},
    Glyph{'A', 4, "M02L28L42M14L34"},
    Glyph{'B', 4, "M05L25Q4544L43Q4222L02L08L28Q4847L46Q4525"},
    Glyph{'C', 4, "M47Q4828Q0805Q0222Q4243"},
    Glyph{'D', 4, "M02L08L18Q4845Q4212L02"},
    Glyph{'E', 4, "M48L08L02L42M05L35"},
    Glyph{'F', 4, "M48L08L02M05L35"},
    Glyph{'G', 4, "M47Q4828Q0805Q0222Q4244L45L25"},
    Glyph{'H', 4, "M08L02M48L42M05L45"},
    Glyph{'I', 0, "M08L02"},
    Glyph{'J', 3, "M38L34Q3212Q0203"},
    Glyph{'K', 4, "M08L02M48L04M15L42"},
    Glyph{'L', 4, "M08L02L42"},
    Glyph{'M', 6, "M02L08L35L68L62"},
    Glyph{'N', 4, "M02L08L42L48"},
    Glyph{'O', 4, "M28Q0805Q0222Q4245Q4828"},
    Glyph{'P', 4, "M02L08L28Q4847L46Q4525L05"},
    Glyph{'Q', 5, "M28Q0805Q0222Q4245Q4828M33L51"},
    Glyph{'R', 4, "M02L08L28Q4847L46Q4525L05M25L42"},
    Glyph{'S', 4, "M47Q4828Q0807Q0525Q4543Q4222Q0203"},
    Glyph{'T', 4, "M08L48M28L22"},
    Glyph{'U', 4, "M08L04Q0222Q4244L48"},
    Glyph{'V', 4, "M08L22L48"},
    Glyph{'W', 6, "M08L12L38L52L68"},
    Glyph{'X', 4, "M08L42M02L48"},
    Glyph{'Y', 4, "M08L25L48M25L22"},
    Glyph{'Z', 4, "M08L48L02L42"},
    Glyph{'.', 0, "M02"},
    Glyph{',', 1, "M12L01"},
    Glyph{':', 0, "M06M03"},
    Glyph{'-', 3, "M05L35"},
    Glyph{'+', 4, "M05L45M23L27"},
    Glyph{'=', 4, "M04L44M06L46"},
    Glyph{'/', 3, "M01L39"},
    Glyph{'%', 6, "M12L58M18Q0807Q0616Q2627Q2818M54Q4443Q4252Q6263Q6454"},
    Glyph{'^', 2, "M06L18L26"},
    Glyph{'_', 4, "M01L41"},
    Glyph{'(', 2, "M29Q0705Q0321"},
    Glyph{')', 2, "M09Q2725Q2301"},
    Glyph{'[', 1, "M19L09L01L11"},
    Glyph{']', 1, "M09L19L11L01"},
    Glyph{'\xB0', 2, "M18Q0807Q0616Q2627Q2818"},
};
constexpr Glyph kUnknown{'?', 4, "M02L08L48L42L02"};
constexpr double kUnit = 1.0 / 6;  // of the height of capitals
constexpr double kGap = 1.7;       // between glyphs, in grid units

const Glyph& glyph_of(char character) {
  const auto found =
      std::find_if(kGlyphs.begin(), kGlyphs.end(), [&](const Glyph& g) { return g.character == character; });
  return found == kGlyphs.end() ? kUnknown : *found;
}

/// UTF-8 to one byte a character (Latin-1); what lies beyond becomes a byte without a glyph.
std::string characters(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if (byte < 0x80) {
      result.push_back(text[i]);
    } else if (byte >= 0xC0) {
      const bool latin1 = byte <= 0xC3 && i + 1 < text.size();
      result.push_back(
          latin1 ? static_cast<char>(((byte & 0x03) << 6) | (static_cast<unsigned char>(text[i + 1]) & 0x3F)) : '\x7F');
    }
  }
  return result;
}

void append_glyph(std::string_view path, double left, std::vector<Stroke>& strokes) {
  const auto point = [&](std::size_t i) { return Vec2{kUnit * (left + path[i] - '0'), kUnit * (path[i + 1] - '2')}; };
  for (std::size_t i = 0; i < path.size();) {
    if (path[i] == 'Q') {
      const Vec2 start = strokes.back().back();
      const Vec2 control = point(i + 1);
      const Vec2 end = point(i + 3);
      constexpr int kPieces = 8;
      for (int k = 1; k <= kPieces; ++k) {
        const double t = static_cast<double>(k) / kPieces;
        strokes.back().push_back((1 - t) * (1 - t) * start + 2 * t * (1 - t) * control + t * t * end);
      }
      i += 5;
      continue;
    }
    if (path[i] == 'M') strokes.emplace_back();
    strokes.back().push_back(point(i + 1));
    i += 3;
  }
}

}  // namespace

std::vector<Stroke> text_strokes(std::string_view text) {
  std::vector<Stroke> strokes;
  double left = 0;
  for (const char character : characters(text)) {
    const Glyph& glyph = glyph_of(character);
    append_glyph(glyph.path, left, strokes);
    left += glyph.width + kGap;
  }
  return strokes;
}

double text_width(std::string_view text) {
  double width = 0;
  for (const char character : characters(text)) width += glyph_of(character).width + kGap;
  return kUnit * std::max(0.0, width - kGap);
}

}  // namespace toile
