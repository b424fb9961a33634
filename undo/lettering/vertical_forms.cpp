#include "undo/lettering/vertical_forms.h"

#include <QString>

#include <algorithm>
#include <array>

namespace suffuse {

namespace {

struct Form {
    char16_t letter, form;
    bool isLatinToo = false; ///< whether letters of that name are narrow in most fonts, and stand in Latin text
};

/// The decompositions <vertical> of Unicode's data, for the characters that are as wide as a square.
constexpr std::array forms = {
    Form{0x2013, 0xfe32, true}, // –
    Form{0x2014, 0xfe31, true}, // —
    Form{0x2025, 0xfe30, true}, // ‥
    Form{0x2026, 0xfe19, true}, // …
    Form{0x3001, 0xfe11},       // 、
    Form{0x3002, 0xfe12},       // 。
    Form{0x3008, 0xfe3f},       // 〈
    Form{0x3009, 0xfe40},       // 〉
    Form{0x300a, 0xfe3d},       // 《
    Form{0x300b, 0xfe3e},       // 》
    Form{0x300c, 0xfe41},       // 「
    Form{0x300d, 0xfe42},       // 」
    Form{0x300e, 0xfe43},       // 『
    Form{0x300f, 0xfe44},       // 』
    Form{0x3010, 0xfe3b},       // 【
    Form{0x3011, 0xfe3c},       // 】
    Form{0x3014, 0xfe39},       // 〔
    Form{0x3015, 0xfe3a},       // 〕
    Form{0x3016, 0xfe17},       // 〖
    Form{0x3017, 0xfe18},       // 〗
    Form{0xff01, 0xfe15},       // ！
    Form{0xff08, 0xfe35},       // （
    Form{0xff09, 0xfe36},       // ）
    Form{0xff0c, 0xfe10},       // ，
    Form{0xff1a, 0xfe13},       // ：
    Form{0xff1b, 0xfe14},       // ；
    Form{0xff1f, 0xfe16},       // ？
    Form{0xff3b, 0xfe47},       // ［
    Form{0xff3d, 0xfe48},       // ］
    Form{0xff3f, 0xfe33},       // ＿
    Form{0xff5b, 0xfe37},       // ｛
    Form{0xff5d, 0xfe38},       // ｝
};
static_assert(std::ranges::is_sorted(forms, {}, &Form::letter));

constexpr double square = 0.9; ///< ems; a letter that is wider than this stands in a square

char32_t codeOf(QStringView letter)
{
    if (letter.size() > 1 && letter[0].isHighSurrogate() && letter[1].isLowSurrogate())
        return QChar::surrogateToUcs4(letter[0], letter[1]);
    return letter[0].unicode();
}

} // namespace

std::optional<QChar> verticalFormOf(QStringView letter, double width)
{
    if (letter.size() != 1)
        return {};
    const auto at = std::ranges::lower_bound(forms, letter[0].unicode(), {}, &Form::letter);
    if (at == forms.end() || at->letter != letter[0].unicode() || (at->isLatinToo && width <= square))
        return {};
    return QChar(at->form);
}

Stand standOf(QStringView letter, bool hasVerticalForm)
{
    if (letter.isEmpty())
        return Stand::Turned;
    if (hasVerticalForm)
        return Stand::Upright;
    const char32_t c = codeOf(letter);
    switch (c) {
    case 0x3001: // 、
    case 0x3002: // 。
    case 0xff0c: // ，
    case 0xff0e: // ．
        return Stand::OtherCorner;
    case 0x30fc: // ー
    case 0x301c: // 〜
    case 0x3030:
    case 0x30a0:
    case 0xff5e: // ～
    case 0xff0d:
    case 0xff1a: // ：
    case 0xff1b:
    case 0xff1d:
    case 0xffe3:
    case 0xff3f:
    case 0xff5c:
        return Stand::Turned;
    default:
        break;
    }
    const bool isBracket = (c >= 0x3008 && c <= 0x3011) || (c >= 0x3014 && c <= 0x301f) || c == 0xff08 || c == 0xff09 ||
                           c == 0xff3b || c == 0xff3d || (c >= 0xff5b && c <= 0xff60) || c == 0xff1c || c == 0xff1e;
    if (isBracket)
        return Stand::Turned;
    const bool isSquare =
        (c >= 0x1100 && c <= 0x11ff) || (c >= 0x2e80 && c <= 0xa4cf) || (c >= 0xa960 && c <= 0xa97f) ||
        (c >= 0xac00 && c <= 0xd7ff) || (c >= 0xf900 && c <= 0xfaff) || (c >= 0xfe10 && c <= 0xfe1f) ||
        (c >= 0xfe30 && c <= 0xfe4f) || (c >= 0xff01 && c <= 0xff60) || (c >= 0xffe0 && c <= 0xffe6) ||
        (c >= 0x1f000 && c <= 0x1faff) || (c >= 0x1b000 && c <= 0x1b16f) || (c >= 0x20000 && c <= 0x3ffff);
    return isSquare ? Stand::Upright : Stand::Turned;
}

} // namespace suffuse
