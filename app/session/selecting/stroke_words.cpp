#include "app/session/selecting/stroke_words.h"

#include "app/session/colour/colour_words.h"
#include "model/colour/colour_shift.h"
#include "model/colour/colour_uses.h"

#include <QCoreApplication>

#include <algorithm>

namespace suffuse {

namespace {

QString strokeWord(const char *text)
{
    return QCoreApplication::translate("StrokeWords", text);
}

QString strokeTitle(const Stroke &stroke)
{
    return stroke.name.isEmpty() ? strokeWord(QT_TRANSLATE_NOOP("StrokeWords", "stroke %1")).arg(stroke.id) : stroke.name;
}

QString styleWordOf(const Stroke &stroke)
{
    switch (stroke.style.kind) {
    case StyleKind::Uniform:
        return strokeWord(QT_TRANSLATE_NOOP("StrokeWords", "even"));
    case StyleKind::Feathering:
        return strokeWord(QT_TRANSLATE_NOOP("StrokeWords", "feathered"));
    case StyleKind::Edge:
        return strokeWord(QT_TRANSLATE_NOOP("StrokeWords", "dark edge"));
    }
    return {};
}

/// The name of the stroke's colour; of several names the one in its middle.
QString colourWordOf(const Stroke &stroke)
{
    if (stroke.picture)
        return strokeWord(QT_TRANSLATE_NOOP("StrokeWords", "picture"));
    const QString word = wordOf(shownColourOf(stroke));
    const bool several = std::ranges::any_of(stroke.segments, [&](const Segment &segment) {
        return !segment.takesPaint() && !(withOpacity(segment.colour, 1) == withOpacity(shownColourOf(stroke), 1)) &&
               wordOf(segment.colour) != word;
    });
    return several ? strokeWord(QT_TRANSLATE_NOOP("StrokeWords", "%1 and other colours")).arg(word) : word;
}

} // namespace

QString wordsOf(const Stroke &stroke)
{
    QStringList words{strokeTitle(stroke), styleWordOf(stroke), colourWordOf(stroke)};
    if (stroke.fill)
        words << strokeWord(QT_TRANSLATE_NOOP("StrokeWords", "filled"));
    words << QCoreApplication::translate("StrokeWords", "%Ln segment(s)", nullptr, int(stroke.segments.size()));
    //: between "stroke 12" and "dark edge"
    return words.join(strokeWord(QT_TRANSLATE_NOOP("StrokeWords", ", ")));
}

QString stateWordsOf(const Painting &painting, const Stroke &stroke)
{
    QStringList words;
    if (!painting.isVisible(stroke))
        words << strokeWord(QT_TRANSLATE_NOOP("StrokeWords", "hidden"));
    if (painting.isLocked(stroke))
        words << strokeWord(QT_TRANSLATE_NOOP("StrokeWords", "locked"));
    return words.join(strokeWord(QT_TRANSLATE_NOOP("StrokeWords", ", ")));
}

QString wordsOfSelected(const Painting &painting, const std::set<StrokeId> &strokes)
{
    const StrokePtr only = strokes.size() == 1 ? painting.find(*strokes.begin()) : nullptr;
    return only ? wordsOf(*only)
                : QCoreApplication::translate("StrokeWords", "%Ln stroke(s)", nullptr, int(strokes.size()));
}

} // namespace suffuse
