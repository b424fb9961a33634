// The underlay: it comes from a file, is edited, undone and saved like all else, and is in no picture that is exported.
#include "app/dialogs/export/export_dialog.h"
#include "app/panels/inspector/inspector_panel.h"
#include "app/panels/inspector/underlay_section.h"
#include "app/session/files/underlay_image.h"
#include "app/widgets/asking/messages.h"
#include "app/widgets/look/section.h"
#include "model/formats/files.h"
#include "tests/app/panel_bench.h"
#include "tests/app/session.h"

#include <QComboBox>
#include <QDropEvent>
#include <QFileDialog>
#include <QImageWriter>
#include <QMenu>
#include <QMimeData>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTimer>
#include <QToolButton>

using namespace suffuse;

namespace {

/// Chooses a file in the file dialog that is about to open, by keys.
void answerFileDialog(const QString &path)
{
    QTimer::singleShot(0, qApp, [path] {
        auto *dialog = qobject_cast<QFileDialog *>(QApplication::activeModalWidget());
        if (!dialog)
            return answerFileDialog(path); // it is still to come
        auto *name = dialog->findChild<QLineEdit *>("fileNameEdit");
        QVERIFY(name);
        name->setText(path);
        QTest::keyClick(name, Qt::Key_Return);
    });
}

UnderlaySection &sectionOf(MainWindow &window)
{
    return *window.findChild<InspectorPanel *>()->underlaySection();
}

} // namespace

class TestUnderlay : public QObject {
    Q_OBJECT

private slots:
    void init();
    void cleanup() { setMessageHooks({}); }
    void importedUndoneRedone();
    void photographsStandUpright();
    void replacedWhereItLies();
    void savedAndReopened();
    void opacityDragIsOneStep();
    void placeAndSize();
    void shownAndHidden();
    void notInExports();
    void refusedWithAReason_data();
    void refusedWithAReason();
    void refusedInTheInspector();
    void droppedPicture();
    void damagedInTheDocument();

private:
    QString pathOf(const QString &name) const { return m_folder->filePath(name); }
    /// A picture file of the size, and its path.
    QString picture(const QString &name, QSize size, const QColor &colour = Qt::red) const;
    /// By the menu.
    void import(Session &s, const QString &path) const;

    std::unique_ptr<QTemporaryDir> m_folder;
};

void TestUnderlay::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    QVERIFY(m_folder->isValid());
    qputenv("SUFFUSE_SETTINGS", pathOf("settings.ini").toUtf8());
    qputenv("SUFFUSE_PRESENTER", "raster");
}

QString TestUnderlay::picture(const QString &name, QSize size, const QColor &colour) const
{
    QImage image(size, QImage::Format_RGB32);
    image.fill(colour);
    image.save(pathOf(name));
    return pathOf(name);
}

void TestUnderlay::import(Session &s, const QString &path) const
{
    answerFileDialog(path);
    s.use(Command::ImportUnderlay);
}

void TestUnderlay::importedUndoneRedone()
{
    Session s;
    s.editor().newPainting(Canvas{});
    QVERIFY(!s.window.action(Command::ShowUnderlay).isEnabled());
    const QString path = picture("photo.png", {200, 100});
    import(s, path);
    QVERIFY(s.painting().underlay);
    const auto underlay = s.painting().underlay;
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(*underlay->image, file.readAll());
    QCOMPARE(underlay->area, Rect::of(0, 128, 1024, 512)); // in the middle of 1024 × 768
    QCOMPARE(underlay->opacity, 0.5f);
    QVERIFY(underlay->visible);
    QCOMPARE(s.editor().undoStack().count(), 1);
    QCOMPARE(s.editor().undoStack().undoText(), QStringLiteral("Import underlay"));
    QVERIFY(s.editor().isModified());
    QVERIFY(s.window.action(Command::ShowUnderlay).isChecked());
    s.use(Command::Undo);
    QVERIFY(!s.painting().underlay);
    QVERIFY(!s.window.action(Command::ShowUnderlay).isEnabled());
    s.use(Command::Redo);
    QVERIFY(s.painting().underlay);
    QCOMPARE(*s.painting().underlay, *underlay);
}

/// A picture of a camera that was held sideways.
void TestUnderlay::photographsStandUpright()
{
    QImage image(200, 100, QImage::Format_RGB32);
    image.fill(Qt::red);
    for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 100; ++x)
            image.setPixelColor(x, y, Qt::blue); // the left half
    QImageWriter writer(pathOf("phone.jpg"), "jpg");
    writer.setTransformation(QImageIOHandler::TransformationRotate90); // Exif's 6: the left is the top
    QVERIFY(writer.write(image));
    Session s;
    s.editor().newPainting(Canvas{});
    import(s, pathOf("phone.jpg"));
    const auto underlay = s.painting().underlay;
    QVERIFY(underlay);
    QCOMPARE(underlay->area, Rect::of(320, 0, 384, 768));
    const auto decoded = decodeUnderlay(underlay->image, "phone");
    QVERIFY(decoded);
    const QImage &shown = (*decoded)->levels.front();
    QCOMPARE(shown.size(), QSize(100, 200));
    QVERIFY(shown.pixelColor(50, 40).blue() > 200 && shown.pixelColor(50, 160).red() > 200);
}

void TestUnderlay::replacedWhereItLies()
{
    Session s;
    s.editor().newPainting(Canvas{});
    UnderlaySection &section = sectionOf(s.window);
    answerFileDialog(picture("first.png", {200, 100}));
    QTest::mouseClick(section.addButton(), Qt::LeftButton);
    QVERIFY(s.painting().underlay);
    type(*section.field(UnderlaySection::Number::Width), "400");
    QCOMPARE(s.painting().underlay->area, Rect::of(0, 128, 400, 200));
    section.opacity()->number()->setFocus();
    type(*section.opacity()->number(), "80");
    answerFileDialog(picture("second.jpg", {100, 100}));
    QTest::mouseClick(section.replaceButton(), Qt::LeftButton);
    QCOMPARE(s.painting().underlay->area, Rect::of(100, 128, 200, 200));
    QCOMPARE(s.painting().underlay->opacity, 0.8f);
    QCOMPARE(s.editor().undoStack().undoText(), QStringLiteral("Replace underlay"));
    QTest::mouseClick(section.fitButton(), Qt::LeftButton);
    QCOMPARE(s.painting().underlay->area, Rect::of(128, 0, 768, 768));
    QTest::mouseClick(section.removeButton(), Qt::LeftButton);
    QVERIFY(!s.painting().underlay);
    QVERIFY(section.addButton()->isVisible());
    QVERIFY(!section.removeButton()->isVisible());
    s.editor().undoStack().setIndex(1);
    QCOMPARE(s.painting().underlay->area, Rect::of(0, 128, 1024, 512));
}

void TestUnderlay::savedAndReopened()
{
    for (const char *ending : {"kept.suffuse", "kept.json"}) {
        Session s;
        s.editor().newPainting(Canvas{});
        s.paintLine({200, 200}, {600, 300});
        import(s, picture("photo.png", {64, 48}));
        QVERIFY(s.painting().underlay);
        const Underlay underlay = *s.painting().underlay;
        QVERIFY(s.window.saveTo(pathOf(ending)));
        QVERIFY(!s.editor().isModified());
        s.window.hide(); // else it is raised
        Session again;
        QCOMPARE(again.window.openFile(pathOf(ending)), &again.window);
        QVERIFY(again.painting().underlay);
        QCOMPARE(*again.painting().underlay, underlay);
        QVERIFY(sectionOf(again.window).removeButton()->isVisible());
    }
}

void TestUnderlay::opacityDragIsOneStep()
{
    Session s;
    s.editor().newPainting(Canvas{});
    import(s, picture("photo.png", {64, 48}));
    UnderlaySection &section = sectionOf(s.window);
    BarSlider *slider = section.opacity()->slider();
    QVERIFY(slider->isVisible());
    QTest::mousePress(slider, Qt::LeftButton, {}, sliderPoint(*slider, 0.5));
    std::set<float> seen;
    for (const double share : {0.4, 0.3, 0.2, 0.1}) {
        QTest::mouseMove(slider, sliderPoint(*slider, share));
        seen.insert(s.painting().underlay->opacity);
    }
    QTest::mouseRelease(slider, Qt::LeftButton, {}, sliderPoint(*slider, 0.1));
    QCOMPARE(seen.size(), std::size_t(4)); // live
    QVERIFY(std::abs(s.painting().underlay->opacity - 0.1f) < 0.03f);
    QCOMPARE(s.editor().undoStack().count(), 2);
    QCOMPARE(s.editor().undoStack().undoText(), QStringLiteral("Change underlay opacity"));
    s.use(Command::Undo);
    QCOMPARE(s.painting().underlay->opacity, 0.5f);
}

void TestUnderlay::placeAndSize()
{
    using Number = UnderlaySection::Number;
    Session s;
    s.editor().newPainting(Canvas{});
    import(s, picture("photo.png", {200, 100}));
    UnderlaySection &section = sectionOf(s.window);
    const auto area = [&] { return s.painting().underlay->area; };
    type(*section.field(Number::X), "10");
    QCOMPARE(s.editor().undoStack().undoText(), QStringLiteral("Move underlay"));
    type(*section.field(Number::Y), "-20");
    QCOMPARE(area(), Rect::of(10, -20, 1024, 512));
    type(*section.field(Number::Height), "*2");
    QCOMPARE(area(), Rect::of(10, -20, 2048, 1024));
    QCOMPARE(s.editor().undoStack().undoText(), QStringLiteral("Resize underlay"));
    QTest::mouseClick(section.proportions(), Qt::LeftButton);
    type(*section.field(Number::Width), "300");
    QCOMPARE(area(), Rect::of(10, -20, 300, 1024));
    const int steps = s.editor().undoStack().count();
    for (int i = 0; i < 3; ++i)
        QTest::keyClick(section.field(Number::X), Qt::Key_Up);
    QCOMPARE(area(), Rect::of(13, -20, 300, 1024));
    QCOMPARE(s.editor().undoStack().count(), steps + 1); // of three presses
    type(*section.field(Number::Width), "0");
    QCOMPARE(area().width(), 300.0);
    QCOMPARE(s.editor().undoStack().count(), steps + 1);
    s.editor().undoStack().setIndex(1);
    QCOMPARE(area(), Rect::of(0, 128, 1024, 512));
    QCOMPARE(section.field(Number::Width)->value(), 1024.0);
}

void TestUnderlay::shownAndHidden()
{
    Session s;
    s.editor().newPainting(Canvas{});
    import(s, picture("photo.png", {64, 48}));
    s.window.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&s.window));
    QTest::keyClick(&s.canvas(), Qt::Key_U, Qt::ShiftModifier);
    QVERIFY(!s.painting().underlay->visible);
    QVERIFY(!sectionOf(s.window).visibility()->isChecked());
    QCOMPARE(s.editor().undoStack().undoText(), QStringLiteral("Hide underlay"));
    QTest::mouseClick(sectionOf(s.window).visibility(), Qt::LeftButton);
    QVERIFY(s.painting().underlay->visible);
    QVERIFY(s.window.action(Command::ShowUnderlay).isChecked());
    QCOMPARE(s.editor().undoStack().count(), 3);
}

void TestUnderlay::notInExports()
{
    Session s;
    s.editor().newPainting(Canvas{});
    s.paintLine({200, 200}, {600, 300});
    s.dry();
    const auto exported = [&](const QString &name) {
        ExportDialog dialog(s.editor(), s.painting().canvas.area());
        dialog.show();
        dialog.widthBox()->setValue(256);
        dialog.path()->setText(pathOf(name)); // needs no image module
        dialog.depth()->setCurrentIndex(dialog.depth()->findData(int(ImageDepth::Float)));
        QTest::mouseClick(dialog.exportButton(), Qt::LeftButton);
        const bool done = QTest::qWaitFor([&] { return dialog.result() == QDialog::Accepted; }, 20'000);
        QFile file(pathOf(name));
        return done && file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    };
    const QByteArray without = exported("without.pfm");
    QVERIFY(without.size() > 256 * 192 * 12);
    import(s, picture("photo.png", {64, 48}));
    QVERIFY(s.painting().underlay && s.painting().underlay->visible);
    QCOMPARE(exported("with.pfm"), without);
}

void TestUnderlay::refusedWithAReason_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("reason");
    QTest::newRow("too large a file") << "large.png"
                                      << "64 MB";
    QTest::newRow("no picture") << "words.png"
                                << "not a PNG";
    QTest::newRow("damaged") << "damaged.png"
                             << "damaged";
    QTest::newRow("too many pixels") << "wide.png"
                                     << "million pixels";
}

void TestUnderlay::refusedWithAReason()
{
    QFETCH(QString, name);
    QFETCH(QString, reason);
    QFile file(pathOf(name));
    QVERIFY(file.open(QIODevice::WriteOnly));
    if (name == "large.png") {
        QVERIFY(file.resize(64 * 1024 * 1024 + 1));
    } else if (name == "words.png") {
        file.write("this is no picture");
    } else {
        QFile whole(picture("whole.png", {300, 200}));
        QVERIFY(whole.open(QIODevice::ReadOnly));
        QByteArray bytes = whole.readAll();
        if (name == "damaged.png")
            bytes.truncate(bytes.size() / 2);
        else
            bytes.replace(16, 4, QByteArray::fromHex("00100000")); // the width in its header
        file.write(bytes);
    }
    file.close();
    Session s;
    s.editor().newPainting(Canvas{});
    QString said;
    setMessageHooks({.error = [&](const QString &message) { said = message; }});
    import(s, pathOf(name));
    QVERIFY2(said.contains(pathOf(name)), qPrintable(said));
    QVERIFY2(said.contains(reason), qPrintable(said));
    QVERIFY(!s.painting().underlay);
    QCOMPARE(s.editor().undoStack().count(), 0);
    QVERIFY(!s.editor().isModified());
}

void TestUnderlay::refusedInTheInspector()
{
    Session s;
    s.editor().newPainting(Canvas{});
    auto *inspector = s.window.findChild<InspectorPanel *>();
    QFile file(pathOf("words.png"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("this is no picture");
    file.close();
    answerFileDialog(file.fileName());
    QTest::mouseClick(inspector->underlaySection()->addButton(), Qt::LeftButton);
    QVERIFY(inspector->hint()->isVisible());
    QVERIFY(inspector->hint()->text().contains("words.png"));
    answerFileDialog(picture("photo.png", {64, 48}));
    QTest::mouseClick(inspector->underlaySection()->addButton(), Qt::LeftButton);
    QVERIFY(s.painting().underlay);
    QVERIFY(!inspector->hint()->isVisible());
}

void TestUnderlay::droppedPicture()
{
    Session s;
    s.editor().newPainting(Canvas{});
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(picture("photo.png", {64, 48}))});
    QDragEnterEvent enter({300, 300}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&s.window, &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent drop({300, 300}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&s.window, &drop);
    QVERIFY(!s.painting().underlay); // It is asked first.
    auto *menu = qobject_cast<QMenu *>(QApplication::activePopupWidget());
    QVERIFY(menu);
    menu->actions().at(1)->trigger();
    menu->close();
    QVERIFY(s.painting().underlay);
    QCOMPARE(s.painting().underlay->area, Rect::of(0, 0, 1024, 768));
    QCOMPARE(s.editor().undoStack().count(), 1);
    QApplication::sendEvent(&s.window, &enter); // A drop ends what it began.
    QDropEvent again({300, 300}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&s.window, &again);
    menu = qobject_cast<QMenu *>(QApplication::activePopupWidget());
    QVERIFY(menu);
    menu->actions().front()->trigger();
    menu->close();
    QCOMPARE(s.painting().groups.size(), std::size_t(1));
    QCOMPARE(s.painting().groups.front().name, QString("photo"));
    QVERIFY(s.painting().strokes.front()->picture && s.painting().underlay);
}

/// A document's own picture that cannot be decoded: it is told, and all else works.
void TestUnderlay::damagedInTheDocument()
{
    Session s;
    QSignalSpy failed(&s.canvas(), &CanvasWidget::underlayFailed);
    auto painting = std::make_shared<Painting>();
    Underlay underlay{std::make_shared<const QByteArray>("no picture"), Rect::of(0, 0, 100, 100)};
    painting->underlay = std::make_shared<const Underlay>(underlay);
    s.editor().document().reset(painting);
    QTRY_COMPARE(failed.size(), 1);
    QVERIFY(s.window.statusBar()->currentMessage().contains("not a PNG"));
    QTest::mouseClick(sectionOf(s.window).fitButton(), Qt::LeftButton);
    QCOMPARE(s.painting().underlay->area, Rect::of(128, 0, 768, 768));
    QTest::mouseClick(sectionOf(s.window).removeButton(), Qt::LeftButton);
    QVERIFY(!s.painting().underlay);
}

QTEST_MAIN(TestUnderlay)
#include "test_underlay.moc"
