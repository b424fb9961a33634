// What goes into a document's file beside the picture: undo history, and how it was looked at.
#include "app/panels/strokes/strokes_panel.h"
#include "app/session/current_layer.h"
#include "model/formats/files.h"
#include "tests/app/session.h"
#include "undo/edits.h"
#include "undo/history/kept_history.h"
#include "undo/layers/group_edits.h"

#include <QFile>
#include <QLabel>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeView>

using namespace suffuse;

namespace {

StrokePtr someStroke(StrokeId id)
{
    auto s = std::make_shared<Stroke>();
    s->id = id;
    s->segments.resize(3);
    for (std::size_t k = 0; k < 3; ++k) {
        const float x = float(10 * k);
        s->segments[k].bezier = {Offset{x, 0}, Offset{x + 3, 0}, Offset{x + 6, 0}, Offset{x + 10, 0}};
    }
    return s;
}

/// Waits until it is on disk.
bool save(Editor &editor, const QString &path)
{
    QSignalSpy saved(&editor, &Editor::saved);
    editor.startSaving(path, true);
    return saved.wait(60'000) && saved.at(0).at(0).value<SaveOutcome>().isSaved();
}

void paint(Editor &editor, int strokes)
{
    for (int k = 0; k < strokes; ++k)
        editor.push(addStrokes(editor.document(), {someStroke(editor.document().takeStrokeId())}, false),
                    QStringLiteral("stroke %1").arg(k));
}

QByteArray historyIn(const QString &path)
{
    const auto document = loadDocument(path);
    return document ? document->extras.history : QByteArray("?");
}

} // namespace

class TestDocumentExtras : public QObject {
    Q_OBJECT

private:
    QTemporaryDir m_folder;
    QString path(const char *name) const { return m_folder.filePath(QString::fromLatin1(name)); }

private slots:
    void historyIsOffAtFirst()
    {
        Editor editor;
        paint(editor, 3);
        QVERIFY(!editor.keepsHistory());
        QVERIFY(save(editor, path("off.suffuse")));
        QVERIFY(historyIn(path("off.suffuse")).isEmpty());
        QCOMPARE(editor.historyBytes(), 0);
    }

    void undoingGoesOn()
    {
        Editor a;
        paint(a, 3);
        a.undoStack().undo();
        a.setKeepsHistory(true);
        QVERIFY(a.isModified());
        QVERIFY(save(a, path("kept.suffuse")));
        QVERIFY(!a.isModified());
        QCOMPARE(a.historyBytes(), historyIn(path("kept.suffuse")).size());
        QVERIFY(a.historyBytes() > 0);
        Editor b;
        QVERIFY(b.open(path("kept.suffuse")));
        QVERIFY(b.keepsHistory() && !b.isModified());
        QCOMPARE(b.historyBytes(), a.historyBytes());
        QCOMPARE(b.undoStack().count(), 3);
        QCOMPARE(b.undoStack().index(), 2);
        QCOMPARE(b.undoStack().undoText(), QStringLiteral("stroke 1"));
        b.undoStack().redo();
        QCOMPARE(b.document().painting()->strokes.size(), std::size_t(3));
        QVERIFY(b.isModified());
        b.undoStack().undo();
        QVERIFY(!b.isModified());
        b.undoStack().setIndex(0);
        QVERIFY(b.document().painting()->strokes.empty());
        b.undoStack().setIndex(2);
        paint(b, 1);
        QVERIFY(save(b, path("kept.suffuse")));
        QVERIFY(b.open(path("kept.suffuse")));
        QCOMPARE(b.undoStack().count(), 3);
    }

    /// A stroke that comes and goes within one step, as letters do that are typed and taken back, is none of the
    /// step's.
    void comesAndGoesWithinAStep()
    {
        Editor a;
        paint(a, 1);
        a.setKeepsHistory(true);
        const StrokePtr first = a.document().painting()->strokes.front();
        auto other = std::make_shared<Stroke>(*first), changed = std::make_shared<Stroke>(*first);
        other->id = a.document().takeStrokeId();
        changed->name = QStringLiteral("named");
        Gesture gesture = a.begin(QStringLiteral("x"));
        Edit comes;
        comes.strokes[other->id] = other;
        comes.order = std::vector<StrokeId>{first->id, other->id};
        gesture.show(comes);
        Edit goes;
        goes.strokes[other->id] = nullptr;
        goes.strokes[first->id] = changed;
        goes.order = std::vector<StrokeId>{first->id};
        gesture.show(goes);
        gesture.commit();
        QCOMPARE(historyOf(a.undoStack()).steps.back().edit.strokes.size(), std::size_t(1));
        QVERIFY(save(a, path("gone.suffuse")));
        Editor b;
        QVERIFY(b.open(path("gone.suffuse")));
        QVERIFY(b.keepsHistory());
        QCOMPARE(b.undoStack().count(), 2);
        b.undoStack().undo();
        QVERIFY(b.document().painting()->strokes.front()->name.isEmpty());
    }

    void itCanBeTakenOut()
    {
        Editor editor;
        paint(editor, 2);
        editor.setKeepsHistory(true);
        QVERIFY(save(editor, path("out.suffuse")));
        QVERIFY(!historyIn(path("out.suffuse")).isEmpty());
        editor.setKeepsHistory(false);
        QVERIFY(editor.isModified());
        QVERIFY(save(editor, path("out.suffuse")));
        QVERIFY(historyIn(path("out.suffuse")).isEmpty());
        QCOMPARE(editor.historyBytes(), 0);
        QCOMPARE(editor.undoStack().count(), 2); // here it stays
    }

    /// Modified means: not as it is on disk.
    void turnedOnAndOffAgainIsNoChange()
    {
        Editor editor;
        paint(editor, 2);
        QVERIFY(save(editor, path("switch.suffuse")));
        QSignalSpy told(&editor, &Editor::fileChanged);
        editor.setKeepsHistory(true);
        QVERIFY(editor.isModified());
        editor.setKeepsHistory(false);
        QVERIFY(!editor.isModified());
        QCOMPARE(told.size(), 2);
        editor.setKeepsHistory(true);
        QVERIFY(save(editor, path("switch.suffuse")));
        QVERIFY(!editor.isModified());
        editor.setKeepsHistory(false);
        QVERIFY(editor.isModified());
        editor.undoStack().undo();
        editor.setKeepsHistory(true);
        QVERIFY(editor.isModified()); // for what was undone
        editor.undoStack().redo();
        QVERIFY(!editor.isModified());

        Editor opened;
        QVERIFY(opened.open(path("switch.suffuse")));
        opened.setKeepsHistory(false);
        QVERIFY(opened.isModified());
        opened.setKeepsHistory(true);
        QVERIFY(!opened.isModified());
        // The text form has no place for steps; saved in it they are as saved as they can be.
        QVERIFY(save(opened, path("switch.json")));
        QVERIFY(!opened.isModified());
    }

    void oneThatDoesNotFitIsLeftOut()
    {
        Editor editor;
        paint(editor, 2);
        editor.setKeepsHistory(true);
        QVERIFY(save(editor, path("fit.suffuse")));
        auto document = loadDocument(path("fit.suffuse"));
        QVERIFY(document);
        document->painting.canvas.width = 77; // by a program that carries the history along
        QVERIFY(saveDocument(document->painting, document->extras, path("fit.suffuse")));
        const auto losses = editor.open(path("fit.suffuse"));
        QVERIFY(losses && losses->empty());
        QVERIFY(editor.leftOut().contains(QLatin1String("another painting")));
        QCOMPARE(editor.document().painting()->canvas.width, 77.0);
        QCOMPARE(editor.undoStack().count(), 0);
        QVERIFY(!editor.isModified() && !editor.keepsHistory());
        QVERIFY(editor.open(path("off.suffuse")));
        QVERIFY(editor.leftOut().isEmpty());
    }

    /// Nothing of the painting is lost: it opens as itself.
    void damageBesideThePicture()
    {
        Editor editor;
        paint(editor, 2);
        editor.setKeepsHistory(true);
        QVERIFY(save(editor, path("beside.suffuse")));
        QFile file(path("beside.suffuse"));
        QVERIFY(file.open(QIODevice::ReadWrite));
        const qint64 at = file.readAll().indexOf("hist") + 20;
        QVERIFY(file.seek(at) && file.write("\xff\x00\xff", 3) == 3);
        file.close();
        Editor opened;
        const auto losses = opened.open(path("beside.suffuse"));
        QVERIFY(losses && losses->empty());
        QCOMPARE(opened.leftOut(), QStringLiteral("Damaged and left out: the undo history. All 2 strokes are here."));
        QCOMPARE(opened.displayName(), QStringLiteral("beside.suffuse"));
        QVERIFY(!opened.isModified() && *opened.document().painting() == *editor.document().painting());
        QVERIFY(save(opened, opened.filePath()));
        QVERIFY(loadPainting(path("beside.suffuse")));
    }

    void newPaintingsKeepNone()
    {
        Editor editor;
        editor.setKeepsHistory(true);
        editor.newPainting(Editor::usualCanvas());
        QVERIFY(!editor.keepsHistory());
    }

    void theViewComesBack()
    {
        Session a;
        paint(a.editor(), 2);
        QVERIFY(a.window.saveTo(path("view.suffuse")));
        QVERIFY(!loadDocument(path("view.suffuse"))->extras.view); // all of it, at the end: as it opens anyway
        paint(a.editor(), 1);                                      // what is as it was saved is not written again
        a.canvas().setZoom(3.5);
        a.canvas().rotateBy(20);
        a.canvas().mirror();
        a.canvas().panBy({40, -25});
        a.editor().clock().lookAt(500'000);
        QVERIFY(a.window.saveTo(path("view.suffuse")));
        a.window.hide(); // else it is raised
        Session b;
        b.window.resize(900, 700);
        QVERIFY(b.window.openFile(path("view.suffuse")));
        const View &was = a.canvas().view(), &is = b.canvas().view();
        QVERIFY(std::hypot(was.centre.x - is.centre.x, was.centre.y - is.centre.y) < 1e-9);
        QCOMPARE(is.scale, was.scale);
        QCOMPARE(is.rotation, was.rotation);
        QCOMPARE(is.mirrored, was.mirrored);
        QVERIFY(is.width != was.width);
        QVERIFY(b.editor().clock().isInPast());
        QCOMPARE(b.editor().clock().time(), Microseconds(500'000));
        QVERIFY(!b.editor().isModified());
    }

    /// The layer and the groups that are open, whatever part of the canvas is seen; and of a painting without them
    /// none.
    void theLayerComesBack()
    {
        Session a;
        paint(a.editor(), 4);
        for (const auto &[strokes, name] : {std::pair(std::set<StrokeId>{1}, "sea"), {{2, 3}, "sky"}}) {
            a.editor().document().setSelection({strokes, {}});
            a.editor().push(groupSelection(a.editor().document(), name), "group");
        }
        a.editor().document().setSelection({});
        a.editor().layer().choose(2);
        const auto isOpen = [](Session &session, StrokeId member) {
            session.editor().laterChanges().flush();
            const auto *panel = session.window.findChild<StrokesPanel *>();
            return panel->view()->isExpanded(panel->viewIndexOf(member).parent());
        };
        QVERIFY(!isOpen(a, 1) && !isOpen(a, 2));
        auto *panel = a.window.findChild<StrokesPanel *>();
        panel->view()->expand(panel->viewIndexOf(1).parent());
        panel->search()->setText("sky"); // The search opens groups for itself only.
        QVERIFY(a.canvas().isFitted());
        QVERIFY(a.window.saveTo(path("layer.suffuse")));
        a.window.hide();
        Session b;
        b.window.resize(900, 700);
        QVERIFY(b.window.openFile(path("layer.suffuse")));
        QCOMPARE(b.editor().layer().group(), GroupId(2));
        QVERIFY(b.canvas().isFitted());
        QVERIFY(isOpen(b, 1) && !isOpen(b, 2));
        QVERIFY(!b.editor().isModified());
    }

    /// So does a layer that has no stroke yet: where it will come, its name, and that it is clipped.
    void aNewLayerComesBack()
    {
        Session a;
        paint(a.editor(), 4);
        a.editor().document().setSelection({{2, 3}, {}});
        a.editor().push(groupSelection(a.editor().document(), "sky"), "group");
        const GroupId sky = a.painting().groups.front().id;
        a.editor().layer().choose(sky);
        a.use(Command::NewClippedLayer);
        const QString name = a.editor().layer().title();
        QVERIFY(a.editor().layer().isComing());
        const auto says = [](Session &session) {
            for (const QLabel *label : session.window.findChild<StrokesPanel *>()->findChildren<QLabel *>())
                if (label->text().contains(session.editor().layer().title()))
                    return label->text();
            return QString();
        };
        QCOMPARE(says(a), "New clipped layer: " + name);
        QVERIFY(a.window.saveTo(path("new.suffuse")));
        a.window.hide();
        Session b;
        QVERIFY(b.window.openFile(path("new.suffuse")));
        QVERIFY(b.editor().layer().isComing());
        QCOMPARE(b.editor().layer().title(), name);
        QCOMPARE(says(b), "New clipped layer: " + name);
        QVERIFY(!b.editor().isModified());
        b.paintLine({200, 300}, {700, 300});
        const Group *layer = b.painting().findGroup(b.painting().strokes[3]->group); // above both strokes of the sky
        QVERIFY(layer && layer->name == name && layer->clips);
        QCOMPARE(b.painting().strokes[2]->group, sky);
        QCOMPARE(b.painting().strokes.size(), std::size_t(5));
    }

    void theMenuSaysWhatHistoryTakes()
    {
        Session s;
        QAction &keep = s.window.action(Command::KeepHistory);
        QVERIFY(keep.isCheckable() && !keep.isChecked());
        const QString title = keep.text();
        paint(s.editor(), 2);
        keep.trigger();
        QVERIFY(s.editor().keepsHistory());
        QVERIFY(s.window.saveTo(path("menu.suffuse")));
        QVERIFY2(keep.text().startsWith(title + " (") && keep.text().endsWith("bytes)"), qPrintable(keep.text()));
        s.window.hide();
        Session t;
        QVERIFY(t.window.openFile(path("menu.suffuse")));
        QVERIFY(t.window.action(Command::KeepHistory).isChecked());
        QVERIFY(t.window.action(Command::Undo).isEnabled());
        t.window.action(Command::KeepHistory).trigger();
        QVERIFY(!t.editor().keepsHistory() && t.editor().isModified());
        QVERIFY(t.window.saveTo(path("menu.suffuse")));
        QCOMPARE(t.window.action(Command::KeepHistory).text(), title);
        QVERIFY(historyIn(path("menu.suffuse")).isEmpty());
    }

    /// Parts that nobody knows, and a preview.
    void theRestIsCarriedAlong()
    {
        Editor editor;
        QVERIFY(editor.open(QStringLiteral(SUFFUSE_SOURCE_DIR "/tests/fixtures/v1/extras.suffuse")));
        paint(editor, 1);
        QVERIFY(save(editor, path("carried.suffuse")));
        const auto document = loadDocument(path("carried.suffuse"));
        QVERIFY(document && document->losses.empty());
        QCOMPARE(document->extras.unknown, (std::vector<AncillaryChunk>{{"zzzz", ""}, {"licn", "CC BY 4.0"}}));
        QVERIFY(document->extras.preview.startsWith("\x89PNG"));
    }
};

QTEST_MAIN(TestDocumentExtras)
#include "test_document_extras.moc"
