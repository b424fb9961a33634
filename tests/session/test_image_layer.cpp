// Pictures as layers: imported, pasted, made of the underlay, linked, missing, and brought back into proportion.
#include "app/session/commands/session_rows.h"
#include "app/session/files/image_layer.h"
#include "app/session/open_painting.h"
#include "model/formats/files.h"
#include "model/shaping/transform.h"
#include "undo/layers/group_roles.h"
#include "undo/transform_edits.h"

#include <QDir>
#include <QFile>
#include <QImage>
#include <QTemporaryDir>
#include <QTest>

using namespace suffuse;

namespace {

QImage photo(int width, int height, QRgb colour = qRgb(200, 30, 60))
{
    QImage image(width, height, QImage::Format_ARGB32);
    image.fill(colour);
    return image;
}

QByteArray bytesOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

class TestImageLayer : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;

    QString path(const QString &name) const { return m_folder.filePath(name); }
    QString saved(const QString &name, const QImage &image) const
    {
        QDir().mkpath(QFileInfo(path(name)).path());
        return image.save(path(name)) ? path(name) : QString();
    }
    static const Painting &paintingOf(OpenPainting &open) { return *open.editor.document().painting(); }
    static const Stroke &onlyStroke(OpenPainting &open) { return *paintingOf(open).strokes.front(); }
    /// Saves and waits for it.
    static void save(Editor &editor, const QString &path)
    {
        editor.startSaving(path, true);
        QTRY_VERIFY(!editor.isSaving());
    }

private slots:
    void importedPictures()
    {
        OpenPainting open;
        open.editor.newPainting(Canvas{});
        QCOMPARE(image_layer::importFile(open.editor, saved("photo of a lake.png", photo(300, 200))), QString());
        QCOMPARE(open.editor.undoStack().count(), 1);
        QCOMPARE(paintingOf(open).groups.size(), std::size_t(1));
        const Group &group = paintingOf(open).groups.front();
        QCOMPARE(group.name, QString("photo of a lake"));
        QVERIFY(group.isolated && !group.draft);
        QCOMPARE(onlyStroke(open).group, group.id);
        QVERIFY(open.editor.selection().strokes.contains(onlyStroke(open).id));
        // A pixel a unit, in the middle of the canvas, and there at this moment.
        QCOMPARE(controlBox(onlyStroke(open)), Rect::of(362, 284, 300, 200));
        QVERIFY(onlyStroke(open).fill->age(open.editor.clock().time()) > 0);
        // A larger one is as large as fits.
        QCOMPARE(image_layer::importFile(open.editor, saved("large.png", photo(4096, 1024))), QString());
        QCOMPARE(controlBox(*paintingOf(open).strokes.back()), Rect::of(0, 256, 1024, 256));
        open.editor.undo();
        open.editor.undo();
        QVERIFY(paintingOf(open).strokes.empty() && paintingOf(open).groups.empty());
    }

    void whatIsNoPicture()
    {
        OpenPainting open;
        QFile file(path("words.png"));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write("no picture") > 0);
        file.close();
        QVERIFY(image_layer::importFile(open.editor, file.fileName()).contains("words.png"));
        QVERIFY(image_layer::importFile(open.editor, path("nothing.png")).contains("nothing.png"));
        QVERIFY(paintingOf(open).strokes.empty());
    }

    void tooManyPixelsAreRefused()
    {
        OpenPainting open;
        auto full = std::make_shared<Painting>();
        for (int i = 0; i < 2; ++i) {
            Stroke stroke;
            stroke.id = StrokeId(i + 1);
            stroke.segments.resize(1);
            Picture picture;
            picture.sha256 = QString(64, QChar('0' + i));
            picture.width = 16'384, picture.height = 4'096;
            stroke.picture = picture;
            full->strokes.push_back(std::make_shared<const Stroke>(stroke));
        }
        open.editor.document().reset(full);
        const QString refused = image_layer::importFile(open.editor, saved("one.png", photo(8, 8)));
        QVERIFY2(refused.contains("134 million"), qPrintable(refused));
        QCOMPARE(paintingOf(open).strokes.size(), std::size_t(2));
    }

    void pastedPictures()
    {
        OpenPainting open;
        open.editor.newPainting(Canvas{});
        QCOMPARE(image_layer::paste(open.editor, photo(40, 20), Point{100, 50}), QString());
        QCOMPARE(controlBox(onlyStroke(open)), Rect::of(80, 40, 40, 20));
        QVERIFY(onlyStroke(open).picture->image && !onlyStroke(open).picture->isLinked());
        QVERIFY(!image_layer::paste(open.editor, QImage(), Point{0, 0}).isEmpty());
    }

    void theUnderlayBecomesALayer()
    {
        OpenPainting open;
        Commands table;
        addSessionRows(table, open);
        open.editor.newPainting(Canvas{});
        table.update();
        QVERIFY(!table[Command::UnderlayToLayer].isEnabled());
        QCOMPARE(image_layer::paste(open.editor, photo(10, 10), Point{5, 5}), QString());
        Underlay underlay;
        underlay.image = std::make_shared<const QByteArray>(bytesOf(saved("under.png", photo(64, 48))));
        underlay.area = Rect::of(10, 20, 320, 120);
        underlay.opacity = 0.25f;
        Edit edit;
        edit.underlay = std::make_shared<const Underlay>(underlay);
        open.editor.push(std::move(edit), "underlay");
        table.update();
        const int steps = open.editor.undoStack().count();
        table[Command::UnderlayToLayer].trigger();
        QCOMPARE(open.editor.undoStack().count(), steps + 1);
        QVERIFY(!paintingOf(open).underlay);
        QCOMPARE(controlBox(onlyStroke(open)), underlay.area); // below all
        QVERIFY(*onlyStroke(open).picture->image == *underlay.image);
        QCOMPARE(int(onlyStroke(open).picture->width), 64);
        const Group *group = paintingOf(open).findGroup(onlyStroke(open).group);
        QVERIFY(group && group->opacity == 0.25f && group->visible);
        open.editor.undo();
        QVERIFY(paintingOf(open).underlay && *paintingOf(open).underlay == underlay);
        QCOMPARE(paintingOf(open).strokes.size(), std::size_t(1));
    }

    void draftsAreNotExported()
    {
        OpenPainting open;
        Commands table;
        addSessionRows(table, open);
        open.editor.newPainting(Canvas{});
        QCOMPARE(image_layer::paste(open.editor, photo(10, 10), Point{5, 5}), QString());
        const PaintingPtr before = open.editor.document().painting();
        QCOMPARE(withoutDrafts(before), before);
        table.update();
        table[Command::DraftGroups].trigger();
        const PaintingPtr draft = open.editor.document().painting();
        QVERIFY(draft->groups.front().draft && draft->isVisible(*draft->strokes.front()));
        QVERIFY(!withoutDrafts(draft)->isVisible(*draft->strokes.front()));
        table.update();
        QVERIFY(table[Command::DraftGroups].isChecked());
        table[Command::DraftGroups].trigger();
        QVERIFY(*open.editor.document().painting() == *before);
    }

    void proportions()
    {
        OpenPainting open;
        open.editor.newPainting(Canvas{});
        QCOMPARE(image_layer::paste(open.editor, photo(40, 20), Point{100, 50}), QString());
        const Stroke before = onlyStroke(open);
        const Affine squeeze = Affine::rotation({100, 50}, 0.3) * Affine::scaling({80, 40}, 2, 0.5);
        const Stroke squeezed = transformed(before, squeeze, SpreadRule::Scales);
        Edit edit;
        edit.strokes.emplace(squeezed.id, std::make_shared<const Stroke>(squeezed));
        open.editor.push(std::move(edit), "squeeze");
        const Point corner = squeezed.origin + squeezed.picture->corner;
        QVERIFY(length(corner - squeeze({80, 40})) < 1e-4);
        image_layer::resetProportions(open.editor);
        const Stroke &even = onlyStroke(open);
        const Affine map = mapOf(*even.picture);
        QVERIFY(map.isSimilarity() || std::abs(map.determinant() - 4) < 1e-4);
        QVERIFY(length(even.origin + even.picture->corner - corner) < 1e-4);
        // The frame has gone along.
        for (std::size_t k = 0; k < 4; ++k) {
            const std::array<Point, 4> places{{{0, 0}, {40, 0}, {40, 20}, {0, 20}}};
            const Point wanted = map(places[k]), there = Point() + even.segments[k].bezier[0];
            QVERIFY(length(wanted - there) < 1e-3);
        }
    }

    /// A painting and its linked picture that move together stay together; what is missing is told and kept.
    void linkedPictures()
    {
        OpenPainting open;
        Editor &editor = open.editor;
        editor.newPainting(Canvas{});
        QCOMPARE(image_layer::paste(editor, photo(10, 10), Point{5, 5}), QString());
        const QString picture = saved("here/pictures/lake.png", photo(32, 16));
        QCOMPARE(image_layer::link(editor, picture), QString());
        QCOMPARE(onlyStroke(open).picture->link, picture);
        QCOMPARE(int(onlyStroke(open).picture->width), 32);
        save(editor, path("here/a.suffuse"));
        const Result<LoadedDocument> file = loadDocument(path("here/a.suffuse"));
        QVERIFY(file && file->missing.isEmpty());
        QCOMPARE(file->painting.strokes.front()->picture->link, QString("pictures/lake.png"));
        QVERIFY(*file->painting.strokes.front()->picture->image == bytesOf(picture));
        QVERIFY(!bytesOf(path("here/a.suffuse")).contains(bytesOf(picture)));

        QVERIFY(QDir(m_folder.path()).rename("here", "there"));
        OpenPainting moved;
        QVERIFY(moved.editor.open(path("there/a.suffuse")));
        QVERIFY2(moved.editor.leftOut().isEmpty(), qPrintable(moved.editor.leftOut()));
        QVERIFY(onlyStroke(moved).picture->image);
        QCOMPARE(onlyStroke(moved).picture->link, path("there/pictures/lake.png"));
        QVERIFY(!moved.editor.isModified());

        QVERIFY(QFile::rename(path("there/pictures/lake.png"), path("lake.png")));
        OpenPainting lacking;
        QVERIFY(lacking.editor.open(path("there/a.suffuse")));
        QVERIFY2(lacking.editor.leftOut().contains("lake.png"), qPrintable(lacking.editor.leftOut()));
        QVERIFY(!onlyStroke(lacking).picture->image);
        save(lacking.editor, path("elsewhere.suffuse"));
        QVERIFY(QFile::rename(path("lake.png"), path("there/pictures/lake.png")));
        OpenPainting whole;
        QVERIFY(whole.editor.open(path("elsewhere.suffuse")));
        QVERIFY(whole.editor.leftOut().isEmpty() && onlyStroke(whole).picture->image);

        saved("there/pictures/lake.png", photo(32, 16, qRgb(0, 0, 9)));
        OpenPainting changed;
        QVERIFY(changed.editor.open(path("elsewhere.suffuse")));
        QVERIFY(changed.editor.leftOut().contains("changed") && !onlyStroke(changed).picture->image);
        changed.editor.document().setSelection({{onlyStroke(changed).id}, {}});
        image_layer::embed(changed.editor); // there is nothing to embed
        QVERIFY(onlyStroke(changed).picture->isLinked());
        QCOMPARE(image_layer::link(changed.editor, path("there/pictures/lake.png")), QString());
        QVERIFY(onlyStroke(changed).picture->image);
        image_layer::embed(changed.editor);
        QVERIFY(!onlyStroke(changed).picture->isLinked() && onlyStroke(changed).picture->image);
        changed.editor.undo();
        QVERIFY(onlyStroke(changed).picture->isLinked());
    }

    /// Steps that are kept in the file have the images of linked pictures, too.
    void linkedPicturesInKeptSteps()
    {
        OpenPainting open;
        Editor &editor = open.editor;
        editor.newPainting(Canvas{});
        QCOMPARE(image_layer::paste(editor, photo(10, 10), Point{5, 5}), QString());
        QCOMPARE(image_layer::link(editor, saved("kept.png", photo(12, 8))), QString());
        image_layer::embed(editor);
        editor.setKeepsHistory(true);
        save(editor, path("kept.suffuse"));
        OpenPainting again;
        QVERIFY(again.editor.open(path("kept.suffuse")));
        QCOMPARE(again.editor.undoStack().count(), editor.undoStack().count());
        again.editor.undo();
        QVERIFY(onlyStroke(again).picture->isLinked() && onlyStroke(again).picture->image);
        again.editor.undo();
        QCOMPARE(int(onlyStroke(again).picture->width), 10);
        QVERIFY(onlyStroke(again).picture->image);
    }
};

QTEST_MAIN(TestImageLayer)
#include "test_image_layer.moc"
