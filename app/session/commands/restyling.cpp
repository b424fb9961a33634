#include "app/session/commands/restyling.h"

#include "app/session/commands/reshaping.h"
#include "app/session/settings/brush_library.h"
#include "app/session/settings/settings.h"
#include "undo/run_edits.h"

#include <QCoreApplication>

namespace suffuse::commands {

namespace {

struct StoredVariation {
    const char *key;
    double VaryAmounts::*amount;
    double least, most;
};
constexpr StoredVariation storedVariations[] = {{"vary/diffusion", &VaryAmounts::diffusion, 0, 100},
                                                {"vary/density", &VaryAmounts::density, 0, 100},
                                                {"vary/maxAge", &VaryAmounts::maxAge, 0, 100},
                                                {"vary/granulation", &VaryAmounts::granulation, 0, 1},
                                                {"vary/hue", &VaryAmounts::hue, 0, 3.15},
                                                {"vary/lightness", &VaryAmounts::lightness, 0, 1},
                                                {"vary/opacity", &VaryAmounts::opacity, 0, 1},
                                                {"vary/length", &VaryAmounts::length, 1e-3, 1e6}};

std::optional<Appearance> &shelf()
{
    static std::optional<Appearance> copied;
    return copied;
}

QString stepNameOf(BrushPart part)
{
    switch (part) {
    case BrushPart::Whole:
        return QCoreApplication::translate("Commands", "Apply brush");
    case BrushPart::Form:
        return QCoreApplication::translate("Commands", "Apply form of the brush");
    case BrushPart::Colour:
        return QCoreApplication::translate("Commands", "Apply colour of the brush");
    case BrushPart::Texture:
        break;
    }
    return QCoreApplication::translate("Commands", "Apply texture of the brush");
}

/// Pushes an edit of the selection, or says why there is none.
QString pushOrSay(Editor &editor, Edit edit, const QString &name)
{
    const Document &document = editor.document();
    if (chosenCount(*document.painting(), document.selection()) == 0)
        return QCoreApplication::translate("Commands", "What is selected is locked or hidden.");
    if (edit.isEmpty())
        return QCoreApplication::translate("Commands", "Nothing changes.");
    editor.push(std::move(edit), name);
    return {};
}

} // namespace

QString applyBrushInHand(Editor &editor, BrushPart part)
{
    const auto brushNamed = [](const QString &name) { return BrushLibrary::instance().find(name); };
    return pushOrSay(editor, applyBrush(editor.document(), editor.brush(), part, brushNamed), stepNameOf(part));
}

void copyAppearance(Editor &editor, StrokeId stroke)
{
    const Document &document = editor.document();
    if (const StrokePtr copied = document.painting()->find(stroke))
        shelf() = appearanceOf(*copied, chosenSegments(*copied, document.selection()));
}

const std::optional<Appearance> &copiedAppearance()
{
    return shelf();
}

QString pasteAppearance(Editor &editor, Variation variation)
{
    if (!shelf())
        return QCoreApplication::translate("Commands", "No appearance was copied.");
    const Document &document = editor.document();
    Edit edit = applyAppearance(document, *document.painting(), document.selection(), *shelf(), variation);
    return pushOrSay(editor, std::move(edit), QCoreApplication::translate("Commands", "Paste appearance"));
}

VaryAmounts storedVariation()
{
    VaryAmounts amounts;
    amounts.density = 0.2;
    amounts.lightness = 0.05;
    for (const StoredVariation &s : storedVariations) {
        const double value = settings::store().value(QLatin1String(s.key), amounts.*s.amount).toDouble();
        if (value >= s.least && value <= s.most)
            amounts.*s.amount = value;
    }
    const int per = settings::store().value(QStringLiteral("vary/per"), int(amounts.per)).toInt();
    if (per >= VaryAmounts::EachStroke && per <= VaryAmounts::Along)
        amounts.per = VaryAmounts::Per(per);
    return amounts;
}

void storeVariation(const VaryAmounts &amounts)
{
    for (const StoredVariation &s : storedVariations)
        settings::store().setValue(QLatin1String(s.key), amounts.*s.amount);
    settings::store().setValue(QStringLiteral("vary/per"), int(amounts.per));
}

} // namespace suffuse::commands
