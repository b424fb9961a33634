#include "app/dialogs/sheet_presets.h"

#include "app/session/editor.h"
#include "model/painting/paper_presets.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <cmath>

namespace suffuse {

namespace {

class Sheets {
    Q_DECLARE_TR_FUNCTIONS(suffuse::Sheets)

public:
    static std::vector<SheetPreset> all();
    static QString titleOfPaper(const QString &name);

private:
    static SheetPreset screen(const QString &name, double width, double height);
    static SheetPreset paper(const QString &name, double width, double height);
    static SheetPreset ground(const QString &name, const Colour &background, std::size_t preset);
};

QString sideText(double value, int decimals)
{
    QString text = QLocale().toString(value, 'f', decimals);
    if (decimals > 0 && text.endsWith('0'))
        text.chop(2);
    return text;
}

SheetPreset Sheets::screen(const QString &name, double width, double height)
{
    Canvas canvas = Editor::usualCanvas();
    canvas.width = width;
    canvas.height = height;
    return {tr("Screen"), name, tr("%1 × %2 px").arg(sideText(width, 0), sideText(height, 0)), canvas, {}};
}

/// Sides in millimetres.
SheetPreset Sheets::paper(const QString &name, double width, double height)
{
    Canvas canvas = Editor::usualCanvas();
    canvas.width = unitsOf(width, usualResolution);
    canvas.height = unitsOf(height, usualResolution);
    const QString metric = tr("%1 × %2 mm").arg(sideText(width, 0), sideText(height, 0));
    const QString imperial =
        tr("%1 × %2 in").arg(sideText(width / millimetresOfInch, 1), sideText(height / millimetresOfInch, 1));
    const bool isMetric = QLocale::system().measurementSystem() == QLocale::MetricSystem;
    return {tr("Paper"), name, (isMetric ? metric : imperial) + QStringLiteral(" · ") + (isMetric ? imperial : metric),
            canvas, QSizeF(width, height)};
}

/// A sheet of the usual size on a ground of its own.
SheetPreset Sheets::ground(const QString &name, const Colour &background, std::size_t preset)
{
    Canvas canvas = Editor::usualCanvas();
    canvas.background = background;
    canvas.paper = paperOf(paperPresets()[preset]);
    return {tr("Templates"), name, titleOf(paperPresets()[preset]), canvas, {}, true};
}

std::vector<SheetPreset> Sheets::all()
{
    enum Papers { Smooth, ColdPress, Rough, Rice, Woven }; // the order of paperPresets()
    return {screen(tr("Sketch"), 1024, 768),
            screen(tr("Full HD"), 1920, 1080),
            screen(tr("4K"), 3840, 2160),
            screen(tr("Square"), 1080, 1080),
            paper(tr("A5"), 210, 148),
            paper(tr("A4"), 297, 210),
            paper(tr("A3"), 420, 297),
            paper(tr("Letter"), 279.4, 215.9),
            paper(tr("Postcard"), 152.4, 101.6),
            ground(tr("Watercolour sheet"), {0.01f, 0.04f, 0, 1}, Rough),
            ground(tr("Rice paper"), {0.03f, 0.09f, 0, 1}, Rice),
            ground(tr("Toned paper"), {0.28f, 0.38f, 0.14f, 1}, ColdPress),
            ground(tr("Night"), {0.86f, 0.82f, 0.97f, 1}, Smooth),
            ground(tr("Canvas"), {0.06f, 0.12f, 0.03f, 1}, Woven)};
}

} // namespace

double unitsOf(double millimetres, double resolution)
{
    return std::max(1.0, std::round(millimetres / millimetresOfInch * resolution));
}

QSizeF SheetPreset::sides(double resolution) const
{
    if (paper.isEmpty())
        return {canvas.width, canvas.height};
    return {unitsOf(paper.width(), resolution), unitsOf(paper.height(), resolution)};
}

QString Sheets::titleOfPaper(const QString &name)
{
    return name == QLatin1String("Letter")    ? tr("Letter")
           : name == QLatin1String("Legal")   ? tr("Legal")
           : name == QLatin1String("Tabloid") ? tr("Tabloid")
                                              : name;
}

QString paperTitle(const QString &name)
{
    return Sheets::titleOfPaper(name);
}

std::vector<SheetPreset> sheetPresets()
{
    return Sheets::all();
}

} // namespace suffuse
