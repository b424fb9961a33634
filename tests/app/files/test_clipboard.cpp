// Cut, copy, paste and drops: between paintings bit for bit, with others as pictures, curves and colours.
#include "app/session/colour_convert.h"
#include "app/session/files/clipboard.h"
#include "app/session/files/svg_strokes.h"
#include "app/widgets/colour/colour_swatch.h"
#include "model/area/outline.h"
#include "model/formats/files.h"
#include "model/paint/derived_figures.h"
#include "model/painting/influence.h"
#include "model/painting/validate.h"
#include "model/shaping/curves/chains.h"
#include "model/shaping/transform.h"
#include "tests/app/panel_bench.h"
#include "tests/app/session.h"
#include "undo/edits.h"
#include "undo/layers/group_edits.h"
#include "undo/node_edits.h"

#include <QClipboard>
#include <QCursor>
#include <QDropEvent>
#include <QGuiApplication>
#include <QImage>
#include <QPainter>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QStatusBar>
#include <QTemporaryDir>

#include <cmath>
#include <set>

using namespace suffuse;

namespace {

bool near(Point a, Point b, double tolerance = 1e-9)
{
    return length(a - b) <= tolerance;
}

/// The curve and values without id and place.
Stroke bare(Stroke stroke)
{
    stroke.id = 0;
    stroke.origin = {};
    return stroke;
}

PaintingPtr withOneStroke()
{
    auto painting = std::make_shared<Painting>();
    painting->strokes = {makeStroke(1, 3, 10)};
    return painting;
}

bool drop(QWidget &widget, QPoint at, QMimeData &data)
{
    QDragEnterEvent enter(at, Qt::CopyAction | Qt::MoveAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&widget, &enter);
    if (!enter.isAccepted())
        return false;
    QDragMoveEvent move(at, Qt::CopyAction | Qt::MoveAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&widget, &move);
    QDropEvent event(at, Qt::CopyAction | Qt::MoveAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&widget, &event);
    return event.isAccepted();
}

} // namespace

class TestClipboard : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toUtf8());
    }

    void betweenWindows()
    {
        Session one, other;
        auto painting = std::make_shared<Painting>();
        painting->groups = {{7, "Trees", 0, true, false}, {9, "Leaves", 7, true, false}};
        for (StrokeId id = 1; id <= 4; ++id) {
            Stroke stroke = *makeStroke(id, 5, 12.34567f * float(id));
            stroke.name = QString("S%1").arg(id);
            stroke.origin = {1e6 / 3 * double(id), -7e5};
            stroke.group = id == 2 ? 7 : id == 3 ? 9 : 0;
            stroke.segments[2].rewet = {{1'000'000, 500'000}};
            painting->strokes.push_back(std::make_shared<const Stroke>(stroke));
        }
        one.editor().document().reset(painting);
        one.editor().document().setSelection({{2, 3, 4}, {}});
        one.use(Command::Copy);
        QVERIFY(QGuiApplication::clipboard()->mimeData()->hasFormat(clipboard::strokesMime));
        QVERIFY(other.window.action(Command::PasteInPlace).isEnabled());

        other.paintLine({200, 200}, {400, 300});
        const PaintingPtr before = other.editor().document().painting();
        const int steps = other.editor().undoStack().count();
        other.use(Command::PasteInPlace);
        QCOMPARE(other.editor().undoStack().count(), steps + 1);
        QCOMPARE(other.painting().strokes.size(), std::size_t(4));
        QCOMPARE(other.selection().strokes.size(), std::size_t(3));
        QVERIFY(problemOf(other.painting()).isEmpty());
        QCOMPARE(other.painting().groups.size(), std::size_t(2));
        for (std::size_t i = 0; i < 3; ++i) {
            Stroke pasted = *other.painting().strokes[i + 1];
            const Stroke &original = *painting->strokes[i + 1];
            QCOMPARE(pasted.group != 0, original.group != 0);
            pasted.id = original.id;
            pasted.group = original.group;
            QCOMPARE(pasted, original); // to the last bit
        }
        other.use(Command::PasteInPlace); // groups and strokes of their own again
        QCOMPARE(other.painting().groups.size(), std::size_t(4));
        QVERIFY(problemOf(other.painting()).isEmpty());
        other.editor().undoStack().setIndex(steps);
        QVERIFY(other.painting() == *before);
    }

    void copiesOfAGroupAreAGroup()
    {
        Session s;
        auto painting = std::make_shared<Painting>();
        painting->groups = {{1, "Trees", 0, true, false}, {2, "Leaves", 1, true, false}};
        for (StrokeId id = 1; id <= 4; ++id) {
            Stroke stroke = *makeStroke(id, 3, 10);
            stroke.group = id == 2 ? 1 : id == 3 ? 2 : 0;
            painting->strokes.push_back(std::make_shared<const Stroke>(stroke));
        }
        s.editor().document().reset(painting);
        for (const bool duplicates : {true, false}) {
            s.editor().document().reset(painting);
            s.editor().document().setSelection({{2, 3}, {}});
            if (!duplicates)
                s.use(Command::Copy);
            s.use(duplicates ? Command::Duplicate : Command::PasteInPlace);
            QVERIFY(problemOf(s.painting()).isEmpty());
            QCOMPARE(s.painting().groups.size(), std::size_t(4));
            const Group &outer = s.painting().groups[2], &inner = s.painting().groups[3];
            QCOMPARE(outer, (Group{outer.id, duplicates ? "Trees" : "Trees copy", 0, true, false}));
            QCOMPARE(inner, (Group{inner.id, "Leaves", outer.id, true, false}));
            QCOMPARE(s.painting().find(2)->group, GroupId(1));
            QCOMPARE(s.selection().strokes.size(), std::size_t(2));
            QCOMPARE(s.painting().find(*s.selection().strokes.begin())->group, outer.id);
            QCOMPARE(s.painting().find(*s.selection().strokes.rbegin())->group, inner.id);
            QCOMPARE(selectedGroup(s.editor().document()), outer.id);
            s.use(Command::Undo);
            QVERIFY(s.painting() == *painting);
        }
    }

    /// All that a group does comes along, but for what hides others.
    void copiesOfAGroupDoWhatItDoes()
    {
        Session s;
        auto painting = std::make_shared<Painting>();
        Group base, group;
        base.id = 1, group.id = 2;
        group.name = "Shade", group.opacity = 0.5f, group.blend = BlendMode::Multiply, group.isolated = true;
        group.clips = group.mask = group.solo = true;
        group.wash = Wash{{StyleKind::Feathering, {1, 1.5f, 0}}, {MixMode::Beta, 0.25f}};
        group.tag = GroupTag::Violet;
        painting->groups = {base, group};
        for (StrokeId id = 1; id <= 4; ++id) {
            Stroke stroke = *makeStroke(id, 3, 10);
            stroke.group = id <= 2 ? 1 : 2;
            painting->strokes.push_back(std::make_shared<const Stroke>(stroke));
        }
        for (const bool duplicates : {true, false}) {
            s.editor().document().reset(painting);
            s.editor().document().setSelection({{3, 4}, {}});
            if (!duplicates)
                s.use(Command::Copy);
            s.use(duplicates ? Command::Duplicate : Command::PasteInPlace);
            QCOMPARE(s.painting().groups.size(), std::size_t(3));
            Group copy = s.painting().groups[2];
            QCOMPARE(copy.solo, duplicates);
            QCOMPARE(copy.name, QString(duplicates ? "Shade" : "Shade copy"));
            copy.id = group.id, copy.solo = true, copy.name = group.name;
            QCOMPARE(copy, group);
        }
    }

    void whatIsPastedIsSeen()
    {
        Session session;
        session.editor().document().reset(withOneStroke());
        session.editor().clock().setTime(1'000'000);
        Painting from;
        Stroke early = *makeStroke(1, 3, 10), late = *makeStroke(2, 3, 20);
        for (std::size_t i = 0; i < 3; ++i) {
            early.segments[i].born = Microseconds(100'000 * i);
            late.segments[i].born = Microseconds(200'000'000 + 100'000 * i);
            late.segments[i].rewet = {{late.segments[i].born + 50'000, 20'000}};
        }
        for (const Stroke &stroke : {early, late})
            from.strokes.push_back(std::make_shared<const Stroke>(stroke));
        const std::unique_ptr<QMimeData> data(clipboard::mimeOf(from, 200'200'000));
        QVERIFY(clipboard::paste(session.editor(), *data, {}).contains("brought back to this moment"));
        const Painting &painting = session.painting();
        QCOMPARE(painting.strokes.size(), std::size_t(3));
        QVERIFY(problemOf(painting).isEmpty());
        for (std::size_t i = 0; i < 3;
             ++i) { // the youngest is born now, the rest as long before it as it was, if it can be
            QCOMPARE(painting.strokes[1]->segments[i].born, Microseconds(0));
            const Segment &segment = painting.strokes[2]->segments[i];
            QCOMPARE(segment.born, Microseconds(800'000 + 100'000 * i));
            QCOMPARE(segment.rewet[0].time, segment.born + 50'000);
        }
        QCOMPARE(session.editor().clock().time(), Microseconds(1'000'000));
    }

    /// What is brought back in time never comes later by that.
    void whatIsBornBeforeTheStartStays()
    {
        Session session;
        session.editor().document().reset(withOneStroke());
        session.editor().clock().setTime(1'000'000);
        Stroke stroke = *makeStroke(2, 3, 10);
        stroke.segments[0].born = -5'000'000;
        stroke.segments[1].born = 2'000'000;
        stroke.segments[2].born = 20'000'000;
        Painting from;
        from.strokes = {std::make_shared<const Stroke>(stroke)};
        QVERIFY(problemOf(from).isEmpty());
        const std::unique_ptr<QMimeData> data(clipboard::mimeOf(from, 20'000'000));
        QVERIFY(!clipboard::paste(session.editor(), *data, {}).isEmpty());
        const Stroke &pasted = *session.painting().strokes.back();
        QCOMPARE(pasted.segments[0].born, Microseconds(-5'000'000));
        QCOMPARE(pasted.segments[1].born, Microseconds(0));
        QCOMPARE(pasted.segments[2].born, Microseconds(1'000'000));
    }

    /// The fill of a stroke is wetted with its last segment, or later.
    void fillsOfWhatIsPastedAreSeen()
    {
        for (const Microseconds later : {0, 500'000}) {
            Session session;
            session.editor().document().reset(withOneStroke());
            session.editor().clock().setTime(1'000'000);
            Painting from;
            Stroke stroke = *makeStroke(1, 3, 10);
            for (Segment &segment : stroke.segments)
                segment.born = 44'000'000;
            Fill fill;
            fill.born = 44'000'000 + later;
            stroke.fill = fill;
            from.strokes.push_back(std::make_shared<const Stroke>(stroke));
            const std::unique_ptr<QMimeData> data(clipboard::mimeOf(from, 60'000'000));
            QVERIFY(!clipboard::paste(session.editor(), *data, {}).isEmpty());
            const Stroke &pasted = *session.painting().strokes.back();
            QCOMPARE(pasted.fill->born, Microseconds(1'000'000));
            QCOMPARE(pasted.segments.front().born, Microseconds(1'000'000 - later));
        }
    }

    void cutAndPasteAtAPlace()
    {
        Session session;
        session.editor().document().reset(std::make_shared<Painting>(*Bench(2).editor.document().painting()));
        const Stroke original = *session.painting().find(2);
        session.editor().document().setSelection({{2}, {}});
        session.use(Command::Cut);
        QVERIFY(!session.painting().find(2));
        QVERIFY(!session.window.action(Command::Cut).isEnabled());
        const QMimeData *data = QGuiApplication::clipboard()->mimeData();
        QCOMPARE(clipboard::paste(session.editor(), *data, Point{500, 400}), QString());
        QCOMPARE(session.editor().undoStack().count(), 2);
        const Stroke &pasted = *session.painting().strokes.back();
        QVERIFY(near(pasted.origin, {460, 400})); // 80 long: its middle is there
        QCOMPARE(bare(pasted), bare(original));
        QVERIFY(pasted.id != 2); // undo may bring that one back
        session.editor().undoStack().setIndex(0);
        QCOMPARE(*session.painting().find(2), original);
    }

    /// One stroke out of a group is a stroke; a group comes where all of it, or several of its members, were copied.
    void groupsComeOnlyWhereTheyAreMeant()
    {
        auto painting = std::make_shared<Painting>();
        painting->groups = {{1, "Trees", 0, true, false}, {2, "Leaves", 1, true, false}};
        for (StrokeId id = 1; id <= 6; ++id) {
            Stroke stroke = *makeStroke(id, 3, 10);
            stroke.group = id <= 3 ? 1 : id <= 5 ? 2 : 0;
            painting->strokes.push_back(std::make_shared<const Stroke>(stroke));
        }
        const auto names = [&](std::set<StrokeId> strokes) {
            const Painting copied = clipboard::asPainting(*painting, {std::move(strokes), {}});
            QStringList result;
            for (const StrokePtr &stroke : copied.strokes) {
                QStringList path;
                for (GroupId group = stroke->group; group;) {
                    const auto it = std::ranges::find(copied.groups, group, &Group::id);
                    if (it == copied.groups.end())
                        return QStringList{"no such group"};
                    path.prepend(it->name);
                    group = it->parent;
                }
                result << path.join('/');
            }
            return result;
        };
        QCOMPARE(names({1}), QStringList{""});
        QCOMPARE(names({4}), QStringList{""});
        QCOMPARE(names({1, 2}), (QStringList{"", ""}));
        QCOMPARE(names({4, 5}), (QStringList{"Leaves", "Leaves"})); // without the group that it is a part of
        QCOMPARE(names({1, 4}), (QStringList{"", ""}));
        QCOMPARE(names({1, 6}), (QStringList{"", ""}));
        QCOMPARE(names({1, 4, 5}), (QStringList{"", "Leaves", "Leaves"}));
        QCOMPARE(names({1, 2, 3, 4, 5}), (QStringList{"Trees", "Trees", "Trees", "Trees/Leaves", "Trees/Leaves"}));
    }

    void whatIsPastedLiesWhereItIsSeen()
    {
        Session session;
        session.editor().document().reset(withOneStroke());
        const std::unique_ptr<QMimeData> data(clipboard::mimeOf(session.painting(), 0));
        const auto middle = [&] { return controlBox(*session.painting().strokes.back()).centre(); };
        const Rect seen = Rect::of(0, 0, 600, 400);
        QCOMPARE(clipboard::paste(session.editor(), *data, {Point{500, 300}, seen}), QString());
        QVERIFY(near(middle(), {500, 300}, 1e-3));
        QCOMPARE(clipboard::paste(session.editor(), *data, {Point{610, 300}, seen}), QString()); // a part is seen
        QVERIFY(near(middle(), {610, 300}, 1e-3));
        QVERIFY(clipboard::paste(session.editor(), *data, {Point{900, -300}, seen}).contains("in the middle"));
        QVERIFY(near(middle(), {300, 200}, 1e-3));
        const Rect elsewhere = Rect::of(5'000, 5'000, 600, 400);
        QVERIFY(clipboard::paste(session.editor(), *data, {std::nullopt, elsewhere}).contains("lies outside"));
        QVERIFY(near(middle(), controlBox(*session.painting().strokes.front()).centre(), 1e-3));
        session.editor().document().reset(withOneStroke());

        // The pointer is in the window, and beside the canvas.
        View view = session.canvas().view();
        view.centre = {0, 300};
        view.scale = 1;
        session.canvas().lookThrough(view);
        view = session.canvas().view();
        const QPoint pointer = QCursor::pos();
        QCursor::setPos(session.canvas().mapToGlobal(QPoint(5, 200)));
        QGuiApplication::clipboard()->setMimeData(clipboard::mimeOf(session.painting(), 0));
        session.use(Command::Paste);
        QCursor::setPos(pointer);
        QVERIFY(session.window.statusBar()->currentMessage().contains("in the middle"));
        Rect box;
        for (const StrokeId id : session.selection().strokes)
            box = box.united(controlBox(*session.painting().find(id)));
        QVERIFY(std::abs(box.centre().x - 0.25 * view.width) < 1); // the right half of the view shows the canvas
    }

    void runsOfSegments()
    {
        Bench bench;
        bench.select({1}, {{1, 0}, {1, 2}, {1, 3}});
        const Painting copied =
            clipboard::asPainting(*bench.editor.document().painting(), bench.editor.document().selection());
        QCOMPARE(copied.strokes.size(), std::size_t(1)); // one stroke, as they were parts of one
        QCOMPARE(chainsOf(*copied.strokes[0]), (std::vector<Chain>{{0, 0}, {1, 2}}));
        QCOMPARE(copied.strokes[0]->segments[2], bench.stroke(1).segments[3]);
        QVERIFY(problemOf(copied).isEmpty());
    }

    void whatErasesIsNoSvg()
    {
        Bench bench;
        Stroke stroke = bench.stroke(1);
        Segment lift = stroke.segments.front();
        lift.start = lift.lift = true;
        stroke.segments.push_back(lift);
        lift.start = false; // It is one erasure, of two segments.
        std::ranges::reverse(lift.bezier);
        stroke.segments.push_back(lift);
        bench.editor.push(replaceStrokes(bench.editor.document(), {stroke}), "lift");
        bench.select({1}, {{1, int(stroke.segments.size()) - 2}, {1, int(stroke.segments.size()) - 1}});
        QVERIFY(clipboard::asPainting(*bench.editor.document().painting(), bench.editor.document().selection())
                    .strokes.empty()); // it lays nothing by itself
        bench.select({1});
        Painting copied =
            clipboard::asPainting(*bench.editor.document().painting(), bench.editor.document().selection());
        const SvgStrokes svg = svgOf(copied);
        QCOMPARE(svg.erasures, 1);
        const auto paths = readSvgPaths(svg.bytes);
        QVERIFY(bool(paths));
        const QString leftOut = clipboard::copy(bench.editor);
        QVERIFY2(leftOut.contains("1 erasure"), qPrintable(leftOut));
        bench.select({2});
        QCOMPARE(clipboard::copy(bench.editor), QString());
    }

    void picturesForOthers()
    {
        Bench bench(1);
        bench.editor.push(changeSegments(bench.editor.document(), {{1, 0}, {1, 1}, {1, 2}, {1, 3}},
                                         [](Segment &s) {
                                             s.density = 20, s.colour = {1, 0, 0, 1};
                                         }),
                          "red");
        bench.select({1});
        const std::unique_ptr<QMimeData> data(clipboard::mimeOf(
            clipboard::asPainting(*bench.editor.document().painting(), bench.editor.document().selection()),
            5'000'000));
        QVERIFY(data->hasImage());
        QImage image;
        QVERIFY(image.loadFromData(data->data("image/png"), "PNG"));
        const Rect reach = influenceOf(bench.stroke(1), 5'000'000);
        QVERIFY(std::abs(image.width() - reach.width()) <= 2 && std::abs(image.height() - reach.height()) <= 2);
        QCOMPARE(qAlpha(image.pixel(0, 0)), 0);
        const QRgb middle = image.pixel(image.width() / 2, image.height() / 2);
        QVERIFY(qAlpha(middle) > 250 && qRed(middle) > 250 && qGreen(middle) < 5 && qBlue(middle) < 5);
    }

    /// What other programs ask for first is up to them; nothing is made before.
    void everyFormIsOffered()
    {
        Bench bench(3);
        bench.select({1, 2, 3});
        QCOMPARE(clipboard::copy(bench.editor), QString());
        const QMimeData *data = QGuiApplication::clipboard()->mimeData();
        for (const char *form : {clipboard::strokesMime, "image/svg+xml", "application/pdf", "image/png"})
            QVERIFY2(data->hasFormat(form), form);
        QVERIFY(data->hasImage());
        // Ours comes first, so that whoever takes the first one that it knows loses nothing.
        QCOMPARE(data->formats().front(), QString(clipboard::strokesMime));
        QVERIFY(data->data("image/svg+xml").contains("<svg"));
    }

    void pdfForOthers_data()
    {
        QTest::addColumn<int>("strokes");
        QTest::addColumn<bool>("isDrawn");
        QTest::addRow("few strokes are drawn") << 3 << true;
        QTest::addRow("many are a picture") << 300 << false;
    }
    void pdfForOthers()
    {
        QFETCH(int, strokes);
        QFETCH(bool, isDrawn);
        Bench bench(strokes);
        const PaintingPtr painting = bench.editor.document().painting();
        Selection all;
        for (const StrokePtr &stroke : painting->strokes)
            all.strokes.insert(stroke->id);
        const Painting copied = clipboard::asPainting(*painting, all);
        const std::unique_ptr<QMimeData> data(clipboard::mimeOf(copied, 5'000'000));
        const QByteArray pdf = data->data("application/pdf");
        QVERIFY(pdf.startsWith("%PDF-"));
        const auto back = readDocument(pdf, "a.pdf");
        QVERIFY2(back, back ? "" : qPrintable(back.error()));
        QVERIFY(back->painting == copied);
        QCOMPARE(back->leftOut, QString());
        if (QStandardPaths::findExecutable("pdftoppm").isEmpty() ||
            QStandardPaths::findExecutable("pdfimages").isEmpty())
            QSKIP("pdftoppm and pdfimages are not installed.");
        const QString path = m_folder.filePath("copied.pdf"), page = m_folder.filePath("copied");
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(pdf) == pdf.size());
        file.close();
        QProcess images;
        images.start("pdfimages", {"-list", path});
        QVERIFY(images.waitForFinished());
        QCOMPARE(images.readAllStandardOutput().contains(" image "), !isDrawn);
        // Other programs see what was copied, on a page that is as large: 96 units are an inch.
        QCOMPARE(QProcess::execute("pdftoppm", {"-r", "96", "-png", "-singlefile", path, page}), 0);
        const QImage seen(page + ".png"), picture = qvariant_cast<QImage>(data->imageData());
        QVERIFY(std::abs(seen.width() - picture.width()) <= 1 && std::abs(seen.height() - picture.height()) <= 1);
        QImage onWhite(picture.size(), QImage::Format_RGB32);
        onWhite.fill(Qt::white);
        QPainter(&onWhite).drawImage(0, 0, picture);
        double sum = 0;
        const int width = std::min(seen.width(), picture.width()), height = std::min(seen.height(), picture.height());
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                sum += std::abs(qGray(seen.pixel(x, y)) - qGray(onWhite.pixel(x, y)));
        const double mean = sum / (double(width) * height);
        QVERIFY2(mean <= 1, qPrintable(QString::number(mean)));
    }

    void pastingFromOthers()
    {
        Session session;
        QMimeData svg;
        svg.setText("  <svg><path d='M0 0L100 0' stroke='#00ff00' stroke-width='30' stroke-linecap='round'/></svg>");
        session.editor().clock().setTime(2'000'000);
        QCOMPARE(clipboard::paste(session.editor(), svg, Point{300, 200}), QString());
        QCOMPARE(session.painting().strokes.size(), std::size_t(1));
        const Stroke &stroke = *session.painting().strokes[0];
        QVERIFY(near(stroke.cubicOf(stroke.segments[0]).p[0], {250, 200}));
        QVERIFY(std::abs(derivedFigures(stroke.segments[0], stroke.style).halfWidth - 15) < 1e-3);
        QCOMPARE(toOpaqueScreen(stroke.segments[0].colour).name(), QString("#00ff00"));
        QVERIFY(session.editor().clock().isRunning()); // it is wet

        // Shapes alone, too; and single elements as they are copied out of a document.
        for (const QString shape :
             {"<rect width='40' height='20'/>", "<circle r='9'/>", "<ellipse rx='9' ry='4'/>", "<line x2='9'/>",
              "<polyline points='0,0 9,9 20,0'/>", "<polygon points='0,0 9,9 20,0'/>"}) {
            const QString styled = QString(shape).replace("/>", " id='own' fill='none' stroke='red'/>");
            for (const QString &text : {"<svg viewBox='0 0 99 99'>" + styled + "</svg>", styled,
                                        "<!-- one -->" + styled + "<g xlink:type='a'>" + styled + "</g>"}) {
                const std::size_t before = session.painting().strokes.size();
                QMimeData pasted;
                pasted.setText(text);
                QCOMPARE(clipboard::paste(session.editor(), pasted, Point{300, 200}), QString());
                QVERIFY2(session.painting().strokes.size() > before, qPrintable(text));
                QCOMPARE(session.painting().strokes[before]->name, QString("own"));
            }
        }
        // As large as Open makes it, its groups with it; in place where its own coordinates say.
        QMimeData millimetres;
        millimetres.setData("image/svg+xml",
                            "<svg viewBox='10 0 100 100' width='200' height='200'><g id='pair' stroke-linecap='round'>"
                            "<path d='M20 0h10' stroke='red'/><path d='M20 9h10' stroke='red'/></g></svg>");
        QCOMPARE(clipboard::paste(session.editor(), millimetres, {}), QString());
        QCOMPARE(session.painting().groups.back().name, QString("pair"));
        const Stroke &last = *session.painting().strokes.back();
        QCOMPARE(last.group, session.painting().groups.back().id);
        QVERIFY(near(last.cubicOf(last.segments[0]).p[0], {40, 18}) &&
                near(last.cubicOf(last.segments[0]).p[3], {60, 18}));

        QMimeData colour;
        colour.setColorData(QColor(255, 0, 0));
        QCOMPARE(clipboard::paste(session.editor(), colour, {}), QString());
        QCOMPARE(toScreen(session.editor().brush().colour).name(), QString("#ff0000"));
        QMimeData hex;
        hex.setText("#0000FF");
        QCOMPARE(clipboard::paste(session.editor(), hex, {}), QString());
        QCOMPARE(toScreen(session.editor().brush().colour).name(), QString("#0000ff"));

        const int steps = session.editor().undoStack().count();
        for (const char *text : {"hello", "<svg><path", "<svg/>"}) {
            QMimeData nothing;
            nothing.setText(text);
            QVERIFY2(!clipboard::paste(session.editor(), nothing, {}).isEmpty(), text);
        }
        QMimeData damaged;
        damaged.setData(clipboard::strokesMime, "{\"format\": \"suffuse-text\", \"version\": 1, \"strokes\": [{}]}");
        QVERIFY(!clipboard::paste(session.editor(), damaged, {}).isEmpty());
        QCOMPARE(session.editor().undoStack().count(), steps);
        // The window says what was wrong.
        QGuiApplication::clipboard()->setText("hello");
        session.use(Command::Paste);
        QVERIFY(!session.window.statusBar()->currentMessage().isEmpty());
    }

    void pastedDrawingsSayWhatIsMissing()
    {
        Session session;
        const auto drawing = [](const char *content) {
            auto *data = new QMimeData;
            data->setData("image/svg+xml", QByteArray("<svg>") + content + "</svg>");
            return data;
        };
        const auto said = [&] { return session.window.statusBar()->currentMessage(); };
        QGuiApplication::clipboard()->setMimeData(drawing("<path d='M0 0h90' fill='none' stroke='red'/>"));
        session.use(Command::Paste);
        QCOMPARE(said(), QString());
        QGuiApplication::clipboard()->setMimeData(drawing("<circle r='50' fill='green'/><text>words</text>"));
        session.use(Command::PasteInPlace);
        QCOMPARE(session.painting().strokes.size(), std::size_t(2));
        QVERIFY2(said().startsWith("1 text(s) were left out"), qPrintable(said()));

        session.window.statusBar()->clearMessage();
        const std::unique_ptr<QMimeData> dropped(drawing("<circle r='50' fill='green'/><image/>"));
        QVERIFY(drop(session.canvas(), session.at({300, 300}), *dropped));
        QCOMPARE(session.painting().strokes.size(), std::size_t(3));
        QVERIFY2(said().startsWith("1 image(s) were left out"), qPrintable(said()));
    }

    void dropsOnTheCanvas()
    {
        Session session;
        auto painting = std::make_shared<Painting>();
        Stroke stroke = *makeStroke(1, 8, 40);
        stroke.origin = {300, 300};
        for (Segment &s : stroke.segments)
            s.density = 20, s.colour.opacity = 0.7f;
        painting->strokes = {std::make_shared<const Stroke>(stroke)};
        session.editor().document().reset(painting);
        session.editor().clock().setTime(5'000'000);

        QMimeData colour;
        colour.setColorData(QColor(0, 0, 255));
        QVERIFY(drop(session.canvas(), session.at({360, 300}), colour));
        for (const Segment &s : session.painting().find(1)->segments) {
            QCOMPARE(toOpaqueScreen(s.colour).name(), QString("#0000ff"));
            QCOMPARE(s.colour.opacity, 0.7f);
        }
        QCOMPARE(session.editor().undoStack().count(), 1);
        drop(session.canvas(), session.at({800, 600}), colour); // nothing lies there
        QCOMPARE(session.editor().undoStack().count(), 1);

        const std::unique_ptr<QMimeData> copy(clipboard::mimeOf(session.painting(), 5'000'000));
        QVERIFY(drop(session.canvas(), session.at({600, 500}), *copy));
        QCOMPARE(session.painting().strokes.size(), std::size_t(2));
        const Stroke &pasted = *session.painting().strokes[1];
        QVERIFY(near(pasted.origin + Point{80, 0}, {600, 500}, 2));
        const int steps = session.editor().undoStack().count();
        QMimeData link; // what has an address is the window's, not a colour
        link.setUrls({QUrl("https://example.org/a.suffuse")});
        link.setColorData(QColor(255, 0, 0));
        QVERIFY(!drop(session.canvas(), session.at({360, 300}), link));
        QCOMPARE(session.editor().undoStack().count(), steps);
    }

    void anErasureIsNotCutAlone()
    {
        Session session;
        Stroke stroke = *makeStroke(1, 8, 40);
        Segment lift = stroke.segments[3];
        lift.lift = lift.start = true;
        stroke.segments.push_back(lift);
        auto painting = std::make_shared<Painting>();
        painting->strokes = {std::make_shared<const Stroke>(stroke)};
        session.editor().document().reset(painting);
        session.editor().document().setSelection({{1}, {{1, 8}}});
        QVERIFY(!clipboard::copy(session.editor()).isEmpty());
        QVERIFY(!clipboard::cut(session.editor()).isEmpty());
        QCOMPARE(session.painting().find(1)->segments.size(), std::size_t(9));
        QCOMPARE(session.editor().undoStack().count(), 0);
        session.editor().document().setSelection({{1}, {{1, 2}}}); // paint
        clipboard::cut(session.editor());
        QCOMPARE(session.painting().find(1)->segments.size(), std::size_t(8));
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestClipboard)
#include "test_clipboard.moc"
