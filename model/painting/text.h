// What a group of letters was made from, so that it can be typed in again.
#pragma once

#include "model/geometry/affine.h"
#include "model/geometry/geometry.h"
#include "model/painting/ids.h"

#include <QString>

#include <memory>
#include <vector>

namespace suffuse {

/// Where the lines of a text begin: at its place, around it, or so that they end there. In writing that runs from the
/// right to the left, the start is on the right.
enum class TextAlignment : std::uint8_t { Start, Centre, End };

/// A text as it was typed and set. Its letters are the strokes of the group that has it, with the outlines of the font:
/// whoever cannot set it, or does not have the font, still has the picture. Its first line stands with its baseline on
/// the x axis, and begins at (0, 0); a vertical one hangs from there, with its middle on the y axis. Domains are
/// checked by `problemOf` (model/painting/validate.h).
struct Text {
    static constexpr int mostCharacters = 100'000; ///< UTF-16
    static constexpr int mostFamily = 1'000;
    static constexpr int mostCurves = 100'000;

    QString string;          ///< lines end with \n
    QString family;          ///< of the font
    float weight = 400;      ///< as fonts count it: 400 regular, 700 bold; [1, 1000]
    bool italic = false;     ///< whether the italic or oblique letters of the family are taken
    double size = 72;        ///< the em, canvas units before `place`; (0, 1e6]
    float letterSpacing = 0; ///< added behind each letter, ems; [-10, 100]
    float lineHeight = 1.2f; ///< from one baseline to the next, ems; [-100, 100]
    TextAlignment alignment = TextAlignment::Start;
    bool vertical = false;    ///< whether lines run from top to bottom, and follow each other from right to left
    Affine place;             ///< from where it is set to where it is
    std::vector<Cubic> curve; ///< the baseline of the first line, canvas units before `place`; empty: a straight one
    StrokeId follows = 0;     ///< the stroke whose first chain `curve` follows; 0, or one that is not there: none does
    Affine followMap;         ///< from that chain, as it is on the canvas, to `curve`

    friend bool operator==(const Text &, const Text &) = default;
};

/// A text, or none. Most groups have none, and copies of a painting share theirs; two are equal if their values are.
class SharedText {
public:
    SharedText() = default;
    SharedText(Text text) : m_text(std::make_shared<const Text>(std::move(text))) {}

    explicit operator bool() const { return bool(m_text); }
    const Text &operator*() const { return *m_text; }
    const Text *operator->() const { return m_text.get(); }

    friend bool operator==(const SharedText &a, const SharedText &b)
    {
        return a.m_text == b.m_text || (a.m_text && b.m_text && *a.m_text == *b.m_text);
    }

private:
    std::shared_ptr<const Text> m_text;
};

} // namespace suffuse
