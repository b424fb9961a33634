// Names that users give to files: what stands behind a dot may be part of one.
#include "app/session/colour_convert.h"
#include "app/session/settings/settings.h"
#include "app/widgets/asking/choose_picture.h"
#include "app/widgets/asking/messages.h"
#include "app/widgets/asking/save_name.h"
#include "model/formats/files.h"
#include "tests/app/file_dialogs.h"
#include "tests/app/session.h"

#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QHeaderView>
#include <QImage>
#include <QLineEdit>
#include <QStandardPaths>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTreeView>

using namespace suffuse;

class TestSaveNames : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_BACKEND", "cpu");
        QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    }
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        qputenv("SUFFUSE_SETTINGS", path("settings.ini").toLocal8Bit());
        m_errors.clear();
        m_answered = m_confirmed = 0;
        m_mayReplace = false;
        MessageHooks hooks;
        m_then = {};
        hooks.error = [this](const QString &message) {
            m_errors << message;
            if (m_then)
                m_then();
        };
        hooks.unsaved = [](const QString &) { return SaveAnswer::Discard; };
        hooks.confirm = [this](const QString &) {
            ++m_confirmed;
            if (m_then)
                m_then();
            return m_mayReplace;
        };
        setMessageHooks(hooks);
    }
    void cleanupTestCase() { setMessageHooks({}); }

    /// Beside the painting, else where one was saved lately, else among pictures or documents; never where the program
    /// happened to be started.
    void savingBeginsInAFolderThatOneKnows()
    {
        const auto folderAsked = [&](Session &s, Command command) {
            QString folder;
            whenAsked<QFileDialog>(this, m_answered, [&](QFileDialog &dialog) {
                folder = dialog.directory().canonicalPath();
                dialog.reject();
            });
            s.use(command);
            return folder;
        };
        const auto made = [&](const QString &name) {
            return QDir(path({})).mkpath(name) ? QFileInfo(path(name)).canonicalFilePath() : QString();
        };
        const auto write = [](const QString &file) { return QFile(file).open(QIODevice::WriteOnly); };
        const QString own = made("own"), recent = made("recent"), gone = made("gone");
        const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
        const QString pictures = QStandardPaths::writableLocation(QStandardPaths::PicturesLocation);
        QVERIFY(QDir().mkpath(documents) && QDir().mkpath(pictures));
        for (const Command command : {Command::SaveAs, Command::SaveCopy}) {
            settings::clearRecentFiles();
            Session s;
            s.paintLine({100, 100}, {200, 100});
            QCOMPARE(folderAsked(s, command), QFileInfo(pictures).canonicalFilePath());
            QVERIFY(write(recent + "/a.suffuse") && write(gone + "/b.suffuse"));
            settings::addRecentFile(recent + "/a.suffuse");
            QCOMPARE(folderAsked(s, command), recent);
            settings::addRecentFile(gone + "/b.suffuse");
            QVERIFY(QDir(gone).removeRecursively());
            QCOMPARE(folderAsked(s, command), recent);
            QVERIFY(s.window.saveTo(own + "/c.suffuse"));
            settings::addRecentFile(recent + "/a.suffuse");
            QCOMPARE(folderAsked(s, command), own);
            QCOMPARE(made("gone"), gone);
        }
    }

    /// So do pictures, brushes and palettes: where one was chosen last.
    void otherFilesHaveAFolderOfTheirOwn()
    {
        const QString pictures = QStandardPaths::writableLocation(QStandardPaths::PicturesLocation);
        QVERIFY(QDir().mkpath(pictures) && QDir(path({})).mkpath("sunsets"));
        QVERIFY(QImage(2, 2, QImage::Format_RGB32).save(path("sunsets/a.png")));
        QStringList folders;
        const auto chosen = [&](const QString &name) {
            whenAsked<QFileDialog>(this, m_answered, [&, name](QFileDialog &dialog) {
                folders << dialog.directory().canonicalPath();
                dialog.reject();
            });
            return name.isEmpty() ? choosePicture(nullptr, "Picture")
                                  : chooseFileToSave(nullptr, "Palette", name, {{"GIMP palettes", {"gpl"}}});
        };
        QVERIFY(chosen({}).isEmpty() && chosen("a.gpl").isEmpty());
        whenAskedForFile(this, m_answered, path("sunsets/a.png"));
        QCOMPARE(choosePicture(nullptr, "Picture"), path("sunsets/a.png"));
        QVERIFY(chosen({}).isEmpty() && chosen("a.gpl").isEmpty());
        const QString usual = QFileInfo(pictures).canonicalFilePath();
        QCOMPARE(folders, QStringList({usual, usual, QFileInfo(path("sunsets")).canonicalFilePath(), usual}));
    }

    /// Size, type and date of files are shown as a whole; names get the room that is left.
    void fileDialogsShowTheirColumns()
    {
        Session s;
        QFile file(path("a painting.suffuse"));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(QByteArray(113'890, 'a')) == 113'890);
        file.close();
        QStringList cutOff;
        bool allWide = false;
        int names = 0, beyond = 0;
        whenAsked<QFileDialog>(this, m_answered, [&](QFileDialog &dialog) {
            dialog.setViewMode(QFileDialog::Detail);
            dialog.setDirectory(m_folder->path());
            auto *tree = dialog.findChild<QTreeView *>(QStringLiteral("treeView"));
            QAbstractItemView *view = tree;
            const auto isWide = [&] {
                cutOff.clear();
                if (tree->model()->rowCount(tree->rootIndex()) == 0)
                    return false;
                for (int column = 1; column < tree->model()->columnCount(); ++column)
                    if (!tree->isColumnHidden(column) && tree->columnWidth(column) < view->sizeHintForColumn(column))
                        cutOff << tree->model()->headerData(column, Qt::Horizontal).toString();
                return cutOff.isEmpty();
            };
            allWide = QTest::qWaitFor(isWide, waitMs); // a thread reads the folder
            names = tree->columnWidth(0);
            beyond = tree->header()->length() - tree->viewport()->width();
            dialog.reject();
        });
        s.use(Command::Open);
        QCOMPARE(m_answered, 1);
        QVERIFY2(allWide, qPrintable(cutOff.join(", ")));
        QVERIFY2(names >= 150 && beyond <= 0, qPrintable(QStringLiteral("%1, %2").arg(names).arg(beyond)));
    }

    void endingsAreAppended_data()
    {
        QTest::addColumn<QString>("given");
        QTest::addColumn<QString>("wanted");
        QTest::newRow("none") << "a"
                              << "a.suffuse";
        QTest::newRow("a version") << "edited v1.0"
                                   << "edited v1.0.suffuse";
        QTest::newRow("a date") << "22.11.2026"
                                << "22.11.2026.suffuse";
        QTest::newRow("its own") << "a.suffuse"
                                 << "a.suffuse";
        QTest::newRow("its own, loud") << "a.SUFFUSE"
                                       << "a.SUFFUSE";
        QTest::newRow("the other kind's") << "a.json"
                                          << "a.json";
        QTest::newRow("another program's") << "a.png"
                                           << "a.png.suffuse";
        QTest::newRow("a dot at the end") << "a."
                                          << "a.suffuse";
        QTest::newRow("a folder's dot") << "v1.0/a"
                                        << "v1.0/a.suffuse";
    }
    void endingsAreAppended()
    {
        QFETCH(const QString, given);
        QFETCH(const QString, wanted);
        const QList<FileKind> kinds{{"Suffuse painting", {"suffuse"}}, {"Text form", {"json"}}};
        QCOMPARE(withEnding(given, kinds, "suffuse"), wanted);
        QCOMPARE(filterOf({"Films", {"webm", "mp4"}}), QString("Films (*.webm *.mp4)"));
    }

    void saveAsAppendsTheEnding()
    {
        Session s;
        s.paintLine({200, 300}, {700, 300});
        QVERIFY(s.window.saveTo(path("a.suffuse")));
        whenAskedForFile(this, m_answered, path("edited v1.0"));
        s.use(Command::SaveAs);
        QTRY_VERIFY_WITH_TIMEOUT(!s.editor().isSaving(), waitMs);
        QCOMPARE(m_answered, 1);
        QVERIFY2(m_errors.isEmpty(), qPrintable(m_errors.join('\n')));
        QCOMPARE(s.editor().filePath(), path("edited v1.0.suffuse"));
        QVERIFY(QFile::exists(path("edited v1.0.suffuse")));
        QVERIFY(!s.window.isWindowModified());
    }

    /// The dialog has asked about the name that was typed; the other one is another file.
    void whatIsThereIsReplacedOnlyIfWanted()
    {
        QFile there(path("edited v1.0.suffuse"));
        QVERIFY(there.open(QIODevice::WriteOnly) && there.write("precious") > 0);
        there.close();
        Session s;
        s.paintLine({200, 300}, {700, 300});
        whenAskedForFile(this, m_answered, path("edited v1.0"));
        m_then = [this] { whenAskedForFile(this, m_answered, path("edited v1.1")); }; // not that one: asks again
        s.use(Command::SaveAs);
        QTRY_VERIFY_WITH_TIMEOUT(!s.editor().isSaving(), waitMs);
        QCOMPARE(m_answered, 2);
        QCOMPARE(m_confirmed, 1);
        QCOMPARE(s.editor().filePath(), path("edited v1.1.suffuse"));
        QVERIFY(bytesOf("edited v1.0.suffuse").startsWith("precious"));
    }

    /// File dialogs take what stands between quotation marks for one of several names.
    void namesThatBecomeOthersAreRefused()
    {
        Session s;
        s.paintLine({200, 300}, {700, 300});
        QVERIFY(s.window.saveTo(path("a.suffuse")));
        for (const char *name : {"my \"best\" work", "say \"hi", ".suffuse"}) {
            m_errors.clear();
            whenAsked<QFileDialog>(this, m_answered, [&](QFileDialog &dialog) {
                auto *field = dialog.findChild<QLineEdit *>("fileNameEdit");
                field->setText(name);
                QTest::keyClick(field, Qt::Key_Return);
                if (dialog.isVisible())
                    dialog.reject();
            });
            s.use(Command::SaveAs);
            QVERIFY2(!s.editor().isSaving(), name);
            QCOMPARE(m_errors.size(), 1);
            QCOMPARE(s.editor().filePath(), path("a.suffuse"));
        }
        QCOMPARE(m_answered, 3);
        QCOMPARE(QDir(m_folder->path()).entryList({"*.suffuse"}, QDir::Files | QDir::Hidden), QStringList{"a.suffuse"});
    }

    /// Whatever fails: what is on disk is what was on disk.
    void aFailedSaveForgetsNothing()
    {
        Session s;
        s.paintLine({200, 300}, {700, 300});
        QVERIFY(s.window.saveTo(path("a.suffuse")));
        for (const char *impossible : {"edited v1.0", "no/such/folder/a.suffuse"}) {
            QVERIFY(!s.window.saveTo(path(impossible)));
            QVERIFY(!s.window.isWindowModified());
            QVERIFY(s.editor().undoStack().isClean());
        }
        s.paintLine({200, 400}, {700, 400});
        QVERIFY(!s.window.saveTo(path("edited v1.0")));
        QVERIFY(s.window.isWindowModified());
        s.use(Command::Undo);
        QVERIFY(!s.window.isWindowModified());
        QVERIFY(s.editor().undoStack().isClean());
        s.use(Command::Undo);
        QVERIFY(s.window.isWindowModified());
        QCOMPARE(m_errors.size(), 3);
    }

    void aCopyLeavesThePaintingWhereItIs()
    {
        Session s;
        s.paintLine({200, 300}, {700, 300});
        QVERIFY(s.window.saveTo(path("a.suffuse")));
        const QByteArray before = bytesOf("a.suffuse");
        s.paintLine({200, 400}, {700, 400});
        whenAskedForFile(this, m_answered, path("a v1.0"));
        s.use(Command::SaveCopy);
        QTRY_VERIFY_WITH_TIMEOUT(!s.editor().isSaving(), waitMs);
        QCOMPARE(m_answered, 1);
        QCOMPARE(hashOf(*loadPainting(path("a v1.0.suffuse"))), hashOf(s.painting()));
        QCOMPARE(bytesOf("a.suffuse"), before);
        QCOMPARE(s.editor().filePath(), path("a.suffuse"));
        QVERIFY(s.window.isWindowModified());
        s.use(Command::Undo);
        QVERIFY(!s.window.isWindowModified());
        QVERIFY(!settings::recentFiles().contains(path("a v1.0.suffuse")));
    }

    /// Other programs get the lines and areas; what was painted stays where it is.
    void aCopyMayBeADrawing()
    {
        Session s;
        s.paintLine({200, 300}, {700, 300});
        QVERIFY(s.window.saveTo(path("a.suffuse")));
        s.paintLine({200, 400}, {700, 400});
        whenAskedForFile(this, m_answered, path("a.svg"));
        s.use(Command::SaveCopy);
        QCOMPARE(m_answered, 1);
        const Result<Painting> drawing = loadPainting(path("a.svg"));
        QVERIFY2(bool(drawing), qPrintable(drawing ? QString() : drawing.error()));
        QVERIFY(drawing->strokes.size() >= 2);
        QVERIFY(bytesOf("a.svg").contains("viewBox=\"0 0 "));
        QCOMPARE(bytesOf("a.svg").count("id=\"background\""), 1);
        QCOMPARE(toOpaqueScreen(drawing->canvas.background).name(),
                 toOpaqueScreen(s.painting().canvas.background).name());
        QVERIFY(s.window.statusBar()->currentMessage().contains("a.svg"));
        QCOMPARE(s.editor().filePath(), path("a.suffuse"));
        QVERIFY(s.window.isWindowModified());
    }

    /// The sheet under the strokes is in it, too, unless there is none.
    void aDrawingHasTheCanvasColour()
    {
        for (const float opacity : {1.0f, 0.5f}) {
            const char *const name = opacity == 1 ? "cream.svg" : "clear.svg";
            Session s;
            s.paintLine({200, 300}, {700, 300});
            Painting painting = s.painting();
            painting.canvas.background = {0.2f, 0.6f, 0.1f, opacity};
            s.editor().document().reset(std::make_shared<const Painting>(painting));
            whenAskedForFile(this, m_answered, path(name));
            s.use(Command::SaveCopy);
            const Result<Painting> drawing = loadPainting(path(name));
            QVERIFY2(bool(drawing), qPrintable(drawing ? QString() : drawing.error()));
            const Colour wanted = opacity == 1 ? painting.canvas.background : Canvas().background;
            QCOMPARE(toOpaqueScreen(drawing->canvas.background).name(), toOpaqueScreen(wanted).name());
            QCOMPARE(bytesOf(name).contains("<rect"), opacity == 1);
            for (const StrokePtr &stroke : drawing->strokes)
                QVERIFY(!stroke->fill);
        }
    }

    /// Saving waits for its turn; a copy that is ordered meanwhile does not take it.
    void aCopyTakesNoSavesPlace()
    {
        Session s;
        for (int i = 0; i < 4; ++i) {
            s.paintLine({200, 300.0 + 50 * i}, {700, 300.0 + 50 * i});
            s.editor().startSaving(path("a.suffuse"), true);
            s.editor().startSavingCopy(path("copy.suffuse"));
        }
        QTRY_VERIFY_WITH_TIMEOUT(!s.editor().isSaving(), waitMs);
        QCOMPARE(hashOf(*loadPainting(path("a.suffuse"))), hashOf(s.painting()));
        QCOMPARE(hashOf(*loadPainting(path("copy.suffuse"))), hashOf(s.painting()));
        QCOMPARE(s.editor().filePath(), path("a.suffuse"));
        QVERIFY(!s.window.isWindowModified());
    }

    /// Two windows would save over each other.
    void anotherWindowsFileIsNoTarget()
    {
        Session a, b;
        a.paintLine({200, 300}, {700, 300});
        QVERIFY(a.window.saveTo(path("a v1.0.suffuse")));
        b.paintLine({200, 400}, {700, 400});
        m_mayReplace = true;
        whenAskedForFile(this, m_answered, path("a v1.0"));
        m_then = [this] {
            if (m_errors.size() == 1)
                whenAsked<QFileDialog>(this, m_answered, [](QFileDialog &dialog) { dialog.reject(); });
        };
        b.use(Command::SaveAs);
        QCOMPARE(m_answered, 2);
        QCOMPARE(m_errors.size(), 1);
        QVERIFY(b.editor().filePath().isEmpty());
        QCOMPARE(hashOf(*loadPainting(path("a v1.0.suffuse"))), hashOf(a.painting()));
    }

private:
    QString path(const QString &name) const { return m_folder->filePath(name); }
    QByteArray bytesOf(const QString &name) const
    {
        QFile file(path(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    QStringList m_errors;
    int m_answered = 0, m_confirmed = 0;
    bool m_mayReplace = false;
    std::function<void()> m_then; ///< when something was asked or said
};

QTEST_MAIN(TestSaveNames)
#include "test_save_names.moc"
