// What happens between the window and files: save, reopen, errors, unsaved work, drops.
#include "app/widgets/asking/messages.h"
#include "model/formats/files.h"
#include "tests/app/session.h"
#include "undo/edits.h"

#include <QDropEvent>
#include <QMimeData>
#include <QStatusBar>
#include <QTemporaryDir>

using namespace suffuse;

class TestEditorFiles : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        qputenv("SUFFUSE_PRESENTER", "raster");
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_SETTINGS", path("settings.ini").toLocal8Bit());
        setMessageHooks({[this](const QString &message) { m_errors << message; },
                         [this](const QString &) {
                             ++m_asked;
                             return m_answer;
                         }});
    }

    void init()
    {
        m_errors.clear();
        m_asked = 0;
        m_answer = SaveAnswer::Discard;
    }

    void changedSegmentSurvivesUndoSaveAndReopen()
    {
        Session s;
        s.paintLine({200, 300}, {700, 350});
        s.dry();
        const QImage painted = s.canvas().picture();
        s.use(Command::Segments);
        s.click({450, 325});
        QCOMPARE(s.selection().segments.size(), std::size_t(1));
        const SegmentRef chosen = *s.selection().segments.begin();
        const float before = s.painting().strokes[0]->segments[chosen.segment].diffusion;
        s.editor().push(changeSegments(s.editor().document(), targetSegments(s.editor().document()),
                                       [](Segment &segment) { segment.diffusion *= 6; }),
                        "Diffusion");
        s.dry();
        const QImage changed = s.canvas().picture();
        QVERIFY(changed != painted);
        s.use(Command::Undo);
        s.dry();
        QCOMPARE(s.painting().strokes[0]->segments[chosen.segment].diffusion, before);
        QCOMPARE(s.canvas().picture(), painted);
        s.use(Command::Redo);
        s.dry();
        QCOMPARE(s.canvas().picture(), changed);

        for (const QString &name : {QStringLiteral("a.suffuse"), QStringLiteral("a.json")}) {
            QVERIFY(s.window.saveTo(path(name)));
            QVERIFY(!s.window.isWindowModified());
            QVERIFY(s.window.windowTitle().startsWith(name));
            s.window.hide(); // else it is raised
            Session other;
            QCOMPARE(other.window.openFile(path(name)), &other.window);
            s.window.show();
            QCOMPARE(hashOf(other.painting()), hashOf(s.painting()));
            QCOMPARE(other.editor().clock().time(), other.painting().end());
            other.dry();
            QCOMPARE(other.canvas().view(), s.canvas().view());
            QCOMPARE(other.canvas().picture(), changed);
        }
        QVERIFY2(m_errors.isEmpty(), qPrintable(m_errors.join('\n')));
    }

    void errorsNameTheFileAndLoseNothing()
    {
        Session s;
        s.paintLine({200, 300}, {700, 300});
        const QByteArray hash = hashOf(s.painting());
        QVERIFY(!s.window.saveTo(path("no/such/folder/b.suffuse")));
        QCOMPARE(m_errors.size(), 1);
        QVERIFY2(m_errors[0].contains("b.suffuse"), qPrintable(m_errors[0]));
        QVERIFY(s.window.isWindowModified());
        QFile foreign(path("foreign.suffuse"));
        QVERIFY(foreign.open(QIODevice::WriteOnly) && foreign.write("not a painting") > 0);
        foreign.close();
        QVERIFY(!s.window.openFile(foreign.fileName()));
        QVERIFY(!s.window.openFile(path("missing.suffuse")));
        QCOMPARE(m_errors.size(), 3);
        QVERIFY2(m_errors[1].contains("foreign.suffuse"), qPrintable(m_errors[1]));
        QVERIFY2(m_errors[2].contains("missing.suffuse"), qPrintable(m_errors[2]));
        QCOMPARE(hashOf(s.painting()), hash);
    }

    void closingAsksForUnsavedWork()
    {
        Session s;
        QVERIFY(s.window.close());
        QCOMPARE(m_asked, 0);
        s.window.show();
        s.paintLine({200, 300}, {700, 300});
        m_answer = SaveAnswer::Cancel;
        QVERIFY(!s.window.close());
        QCOMPARE(m_asked, 1);
        QVERIFY(s.window.saveTo(path("closing.suffuse")));
        QVERIFY(s.window.close());
        QCOMPARE(m_asked, 1);
        s.window.show();
        s.use(Command::Undo);
        QVERIFY(s.window.isWindowModified());
        m_answer = SaveAnswer::Save;
        QVERIFY(s.window.close());
        QCOMPARE(m_asked, 2);
        const Result<Painting> saved = loadPainting(path("closing.suffuse"));
        QVERIFY2(bool(saved), qPrintable(saved.error()));
        QVERIFY(saved->strokes.empty());
    }

    /// What no painting can be saved as has no path yet; the painting of it has its name.
    void droppedRecordingHasItsName()
    {
        QFile csv(path("pen.csv"));
        QVERIFY(csv.open(QIODevice::WriteOnly));
        csv.write("x,y,time,pressure\n");
        for (int i = 0; i < 40; ++i)
            csv.write(QByteArray::number(10 + 5 * i) + ",40," + QByteArray::number(0.016 * i) + ",0.7\n");
        csv.close();
        Session s;
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(csv.fileName())});
        QDragEnterEvent enter(QPoint(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&s.window, &enter);
        QVERIFY(enter.isAccepted());
        QDropEvent drop(QPointF(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&s.window, &drop);
        QVERIFY2(m_errors.isEmpty(), qPrintable(m_errors.join('\n')));
        QCOMPARE(s.painting().strokes.size(), std::size_t(1));
        QVERIFY(s.editor().filePath().isEmpty());
        QCOMPARE(s.editor().displayName(), QString("pen"));
        QCOMPARE(s.editor().suggestedPath(), path("pen.suffuse"));
    }

    void drawingsHaveTheirName()
    {
        QFile svg(path("drawing.svg"));
        QVERIFY(svg.open(QIODevice::WriteOnly));
        svg.write("<svg viewBox='0 0 300 200'><path d='M50 100h200' stroke='red' stroke-width='40'/><image/></svg>");
        svg.close();
        Session s;
        QCOMPARE(s.window.openFile(svg.fileName()), &s.window);
        QVERIFY2(m_errors.isEmpty(), qPrintable(m_errors.join('\n')));
        QCOMPARE(s.painting().canvas.width, 300.0);
        QCOMPARE(s.painting().strokes.size(), std::size_t(1));
        QVERIFY(s.editor().filePath().isEmpty());
        QCOMPARE(s.editor().displayName(), QString("drawing"));
        QCOMPARE(s.editor().suggestedPath(), path("drawing.suffuse"));
        QVERIFY(!s.editor().isModified());
        QVERIFY(s.window.statusBar()->currentMessage().contains("left out"));
        s.dry();
        const Point middle = s.canvas().view().toPixels({150, 100});
        const QColor paint = s.canvas().picture().pixelColor(int(middle.x), int(middle.y));
        QVERIFY2(paint.red() > 200 && paint.green() < 90, qPrintable(paint.name()));

        QVERIFY(svg.open(QIODevice::WriteOnly) && svg.write("<svg>\n<path</svg>") > 0);
        svg.close();
        QVERIFY(!s.window.openFile(svg.fileName()));
        QCOMPARE(m_errors.size(), 1);
        QVERIFY2(m_errors[0].contains("drawing.svg: SVG, line 2"), qPrintable(m_errors[0]));
        QCOMPARE(s.painting().strokes.size(), std::size_t(1));
    }

private:
    QString path(const QString &name) const { return m_folder.filePath(name); }

    QTemporaryDir m_folder;
    QStringList m_errors;
    SaveAnswer m_answer = SaveAnswer::Discard;
    int m_asked = 0;
};

QTEST_MAIN(TestEditorFiles)
#include "test_editor_files.moc"
