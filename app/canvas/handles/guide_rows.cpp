#include "app/canvas/handles/guide_rows.h"

#include "app/canvas/canvas_widget.h"
#include "app/session/commands/commands.h"
#include "app/session/drawing_aids.h"
#include "app/session/editor.h"
#include "app/session/settings/settings.h"
#include "app/widgets/asking/ask_number.h"
#include "app/widgets/numbers/length_units.h"

namespace suffuse {

namespace {

constexpr double farthestGuide = 1e9; ///< canvas units

std::optional<double> askGuidePlace(CanvasWidget &canvas, bool upright, double usual)
{
    return askNumber(canvas.window(), {Commands::tr("Guide"),
                                       upright ? Commands::tr("Horizontal place") : Commands::tr("Vertical place"),
                                       usual, -farthestGuide, farthestGuide, 4, true});
}

void addGuide(CanvasWidget &canvas, bool upright)
{
    DrawingAids &aids = canvas.editor().aids();
    const Point middle = canvas.view().centre;
    if (const auto place = askGuidePlace(canvas, upright, std::round(upright ? middle.x : middle.y))) {
        std::vector<Guide> guides = aids.guides();
        guides.push_back({upright, *place});
        aids.setGuides(std::move(guides));
    }
}

void moveGuide(CanvasWidget &canvas, int number)
{
    DrawingAids &aids = canvas.editor().aids();
    if (number < 0 || number >= int(aids.guides().size()))
        return;
    const Guide guide = aids.guides()[std::size_t(number)];
    const auto place = askGuidePlace(canvas, guide.upright, guide.place);
    std::vector<Guide> guides = aids.guides();
    if (!place || number >= int(guides.size()))
        return;
    guides[std::size_t(number)].place = *place;
    aids.setGuides(std::move(guides));
}

void addUnitRows(Commands &table, CanvasWidget &canvas)
{
    using enum Command;
    const auto add = [&](Command command, RulerUnits units, const QString &id, const QString &text) {
        table.add(command, id, text, "", {})
            .checkable(canvas.aids().rulerUnits == units)
            .toggles([&canvas, units](bool on) {
                CanvasAids now = canvas.aids();
                if (!on)
                    return;
                now.rulerUnits = units;
                canvas.setAids(now);
                settings::setCanvasAids(now);
                if (LengthUnits *lengths = LengthUnits::of(&canvas)) // Fields count as rulers do.
                    lengths->setUnits(units);
            });
    };
    add(RulersInUnits, RulerUnits::Canvas, "rulersInUnits", Commands::tr("Rulers in &Canvas Units"));
    add(RulersInMillimetres, RulerUnits::Millimetres, "rulersInMillimetres", Commands::tr("Rulers in &Millimetres"));
    add(RulersInInches, RulerUnits::Inches, "rulersInInches", Commands::tr("Rulers in &Inches"));
    table.makeExclusive({RulersInUnits, RulersInMillimetres, RulersInInches});
}

} // namespace

void addGuideRows(Commands &table, CanvasWidget &canvas)
{
    using enum Command;
    DrawingAids &aids = canvas.editor().aids();
    const auto addSwitch = [&](Command command, bool CanvasAids::*aid, const QString &id, const QString &text,
                               const QList<QKeySequence> &keys, const QString &tip = {}) {
        table.add(command, id, text, "", keys, tip).checkable(canvas.aids().*aid).toggles([&canvas, aid](bool on) {
            CanvasAids now = canvas.aids();
            now.*aid = on;
            canvas.setAids(now);
            settings::setCanvasAids(now);
        });
    };
    addSwitch(ShowRulers, &CanvasAids::showRulers, "showRulers", Commands::tr("Show the &Rulers"),
              {QKeySequence(Commands::tr("Ctrl+R"))},
              Commands::tr("Along the upper and the left edge; guides are dragged out of them, and back into them"));
    addUnitRows(table, canvas);
    addSwitch(ShowGuides, &CanvasAids::showGuides, "showGuides", Commands::tr("Show the &Guides"), {});
    addSwitch(SnapToGuides, &CanvasAids::snapToGuides, "snapToGuides", Commands::tr("&Snap to Guides"), {},
              Commands::tr("Nodes, shapes and what is moved; paint goes where the hand goes"));
    addSwitch(LockGuides, &CanvasAids::lockGuides, "lockGuides", Commands::tr("&Lock the Guides"), {},
              Commands::tr("They cannot be dragged, and new ones still can be made"));
    table.add(AddLevelGuide, "addLevelGuide", Commands::tr("Add a Le&vel Guide…"), "", {}).runs([&canvas] {
        addGuide(canvas, false);
    });
    table.add(AddUprightGuide, "addUprightGuide", Commands::tr("Add an &Upright Guide…"), "", {}).runs([&canvas] {
        addGuide(canvas, true);
    });
    table.add(RemoveGuides, "removeGuides", Commands::tr("Remove &All Guides"), "", {})
        .when([&aids] { return !aids.guides().empty(); }, Commands::tr("There are no guides."))
        .runs([&aids] { aids.setGuides({}); });
    QObject::connect(&aids, &DrawingAids::changed, &table, [&table] { table.update(RemoveGuides); });
    QObject::connect(
        &canvas, &CanvasWidget::guideAsked, &table, [&canvas](int guide) { moveGuide(canvas, guide); },
        Qt::QueuedConnection); // The dialog opens when the press is dealt with.
}

} // namespace suffuse
