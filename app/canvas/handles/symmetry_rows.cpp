#include "app/canvas/handles/symmetry_rows.h"

#include "app/canvas/canvas_widget.h"
#include "app/session/commands/commands.h"
#include "app/session/drawing_aids.h"
#include "app/session/editor.h"
#include "app/widgets/asking/ask_number.h"

namespace suffuse {

namespace {

constexpr double degreeOfTurn = std::numbers::pi / 180;

/// Changes the symmetry, also where that is what it is already: then the ticks of the menu are set right again.
void changeSymmetry(Commands &table, DrawingAids &aids, Symmetry to)
{
    aids.setSymmetry(to);
    using enum Command;
    for (const Command row : {PaintInSymmetry, SymmetryAcross, SymmetryDown, SymmetryBoth, SymmetryTurns,
                              SymmetryKaleidoscope, SymmetryArms, SymmetryAngle, SymmetryToMiddle})
        table.update(row);
}

void addSymmetryKindRows(Commands &table, DrawingAids &aids)
{
    using enum Command;
    const auto add = [&](Command command, SymmetryKind kind, const QString &id, const QString &text,
                         const QString &tip) {
        table.add(command, id, text, "", {}, tip)
            .checkedWhen([&aids, kind] { return aids.symmetry().isOn && aids.symmetry().kind == kind; })
            .runs([&table, &aids, kind] {
                Symmetry symmetry = aids.symmetry();
                symmetry.isOn = true;
                symmetry.kind = kind;
                changeSymmetry(table, aids, symmetry);
            });
    };
    add(SymmetryAcross, SymmetryKind::Across, "symmetryAcross", Commands::tr("Mirrored &Left and Right"),
        Commands::tr("What is painted on one side of an upright axis comes on the other, too"));
    add(SymmetryDown, SymmetryKind::Down, "symmetryDown", Commands::tr("Mirrored &Top and Bottom"),
        Commands::tr("What is painted above a level axis comes below it, too"));
    add(SymmetryBoth, SymmetryKind::Both, "symmetryBoth", Commands::tr("Mirrored &Both Ways"),
        Commands::tr("What is painted comes in all four corners of a cross"));
    add(SymmetryTurns, SymmetryKind::Turns, "symmetryTurns", Commands::tr("&Rotated around the Centre"),
        Commands::tr("What is painted comes once in each arm around the centre"));
    add(SymmetryKaleidoscope, SymmetryKind::Kaleidoscope, "symmetryKaleidoscope", Commands::tr("&Kaleidoscope"),
        Commands::tr("What is painted comes in each arm around the centre, and mirrored beside it"));
}

} // namespace

void addSymmetryRows(Commands &table, CanvasWidget &canvas)
{
    using enum Command;
    Editor &editor = canvas.editor();
    DrawingAids &aids = editor.aids();
    table
        .add(PaintInSymmetry, "paintInSymmetry", Commands::tr("&Paint in Symmetry"), "",
             {QKeySequence(Commands::tr("Shift+M"))},
             Commands::tr("Strokes, shapes and outlines come several times, mirrored or rotated, as one undo step"))
        .checkedWhen([&aids] { return aids.symmetry().isOn; })
        .runs([&table, &aids] {
            Symmetry symmetry = aids.symmetry();
            symmetry.isOn = !symmetry.isOn;
            changeSymmetry(table, aids, symmetry);
        });
    addSymmetryKindRows(table, aids);
    table.add(SymmetryArms, "symmetryArms", Commands::tr("Number of &Arms…"), "", {})
        .when([&aids] { return aids.symmetry().hasArms(); },
              Commands::tr("Choose a symmetry that turns, or the kaleidoscope, first."))
        .runs([&table, &canvas, &aids] {
            const std::optional<double> arms =
                askNumber(canvas.window(), {Commands::tr("Symmetry"), Commands::tr("Arms around the centre"),
                                            double(aids.symmetry().arms), Symmetry::leastArms, Symmetry::mostArms, 0});
            if (!arms)
                return;
            Symmetry symmetry = aids.symmetry();
            symmetry.arms = int(std::lround(*arms));
            changeSymmetry(table, aids, symmetry);
        });
    table.add(SymmetryAngle, "symmetryAngle", Commands::tr("An&gle of the Axes…"), "", {})
        .runs([&table, &canvas, &aids] {
            const std::optional<double> degrees =
                askNumber(canvas.window(), {Commands::tr("Symmetry"), Commands::tr("Degrees clockwise"),
                                            aids.symmetry().angle / degreeOfTurn, -360, 360, 2});
            if (!degrees)
                return;
            Symmetry symmetry = aids.symmetry();
            symmetry.angle = *degrees * degreeOfTurn;
            changeSymmetry(table, aids, symmetry);
        });
    table
        .add(SymmetryToMiddle, "symmetryToMiddle", Commands::tr("Axes to the &Middle of the Canvas"), "", {},
             Commands::tr("The centre of the symmetry lies in the middle again, and the axes are upright and level"))
        .runs([&table, &editor, &aids] {
            Symmetry symmetry = aids.symmetry();
            symmetry.centre = DrawingAids::usualSymmetry(editor.unsettled().painting()->canvas.area()).centre;
            symmetry.angle = 0;
            changeSymmetry(table, aids, symmetry);
        });
    QObject::connect(&aids, &DrawingAids::changed, &table,
                     [&table, &aids] { changeSymmetry(table, aids, aids.symmetry()); });
}

} // namespace suffuse
