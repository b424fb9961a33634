// Print: where on the paper the picture lies, what another program finds in the PDF, that nothing is left half done,
// and what the document keeps of it.
#include "app/dialogs/print/print_dialog.h"
#include "app/dialogs/print/sheet_view.h"
#include "app/session/settings/settings.h"
#include "app/widgets/look/section.h"
#include "model/formats/files.h"
#include "render/backends.h"
#include "tests/app/selecting.h"
#include "tests/render/paintings.h"

#include <QBuffer>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QElapsedTimer>
#include <QLineEdit>
#include <QPdfWriter>
#include <QProcess>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTemporaryDir>

#include <cstring>
#include <fstream>

using namespace suffuse;

namespace {

/// What the kernel counts of this process, KiB: "VmRSS:" is what it has, "VmHWM:" the most that it has had.
long memory(const char *what)
{
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with(what))
            return std::strtol(line.c_str() + std::strlen(what), nullptr, 10);
    return 0;
}

/// From now on the most is counted anew.
void forgetPeak()
{
    std::ofstream("/proc/self/clear_refs") << "5";
}

} // namespace

class TestPrintDialog : public QObject {
    Q_OBJECT

    /// Soft strokes on a canvas of 600 × 400 units with a colour.
    static void fill(Editor &editor, int count = 6)
    {
        auto painting = std::make_shared<Painting>();
        painting->canvas.width = 600;
        painting->canvas.height = 400;
        painting->canvas.background = {0.05f, 0.2f, 0, 1};
        for (int i = 0; i < count; ++i) {
            const Point centre{100.0 + (i * 83) % 400, 80.0 + (i * 57) % 240};
            Stroke stroke =
                test::stroke(StrokeId(i + 1), test::Shape::Looping, centre, 90, 6, test::styleOf(StyleKind::Uniform));
            painting->strokes.push_back(std::make_shared<const Stroke>(std::move(stroke)));
        }
        editor.document().reset(painting);
    }
    QStringList files() const
    {
        return QDir(m_folder.path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot);
    }
    static void choose(QComboBox *box, const QVariant &data) { box->setCurrentIndex(box->findData(data)); }
    static void chooseSize(PrintDialog &dialog, PrintSetup::Size size) { choose(dialog.sizeBox(), int(size)); }

    /// A page of a PDF as poppler draws it.
    QImage drawn(const QString &pdf, int dpi) const
    {
        const QString out = m_folder.filePath("page");
        QProcess poppler;
        poppler.start("pdftoppm", {"-r", QString::number(dpi), "-png", "-singlefile", pdf, out});
        if (!poppler.waitForFinished(waitMs) || poppler.exitCode() != 0)
            return {};
        const QImage page(out + ".png");
        QFile::remove(out + ".png");
        return page.convertToFormat(QImage::Format_RGB32);
    }

    /// The picture of the plan by the renderer, on a white sheet.
    static QImage expected(const Editor &editor, const PagePlan &plan, double dpi, bool background)
    {
        auto painting = std::make_shared<Painting>(*editor.unsettled().painting());
        if (!background)
            painting->canvas.background = {0, 0, 0, 1};
        const auto renderer = makeRenderer({.backend = Backend::Cpu});
        RenderRequest request;
        request.painting = painting;
        request.time = painting->end();
        request.view = plan.view(dpi);
        Picture8 picture;
        if (!renderer || !(*renderer)->render(request, picture))
            return {};
        QImage sheet(plan.sheet(dpi), QImage::Format_RGB32);
        sheet.fill(Qt::white);
        const PixelRect at = plan.dots(dpi);
        for (int y = 0; y < picture.height; ++y)
            for (int x = 0; x < picture.width; ++x)
                sheet.setPixel(at.x + x, at.y + y, picture.argb[std::size_t(y) * picture.width + x]);
        return sheet;
    }

    /// The mean difference of a channel, of 255; none where the sizes differ by more than a pixel.
    static double meanDifference(const QImage &a, const QImage &b)
    {
        if (a.isNull() || std::abs(a.width() - b.width()) > 1 || std::abs(a.height() - b.height()) > 1)
            return 255;
        const int width = std::min(a.width(), b.width()), height = std::min(a.height(), b.height());
        double sum = 0;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const QRgb p = a.pixel(x, y), q = b.pixel(x, y);
                sum += std::abs(qRed(p) - qRed(q)) + std::abs(qGreen(p) - qGreen(q)) + std::abs(qBlue(p) - qBlue(q));
            }
        return sum / (3.0 * width * height);
    }

    static void print(PrintDialog &dialog, const QString &path)
    {
        dialog.path()->setText(path);
        QTRY_VERIFY_WITH_TIMEOUT(dialog.exportButton()->isEnabled(), waitMs);
        dialog.exportButton()->click();
        QTRY_VERIFY_WITH_TIMEOUT(!dialog.isVisible(), waitMs);
    }

private slots:
    void initTestCase() { qputenv("SUFFUSE_SETTINGS", QDir(m_settings.path()).filePath("settings.ini").toLocal8Bit()); }

    void init()
    {
        settings::store().clear();
        for (const QString &name : files())
            QDir(m_folder.path()).remove(name);
    }

    /// 600 × 400 units are 101.6 × 67.7 mm where nothing else is said, since 150 units are an inch.
    void thePictureLiesWhereItShould()
    {
        const Rect area = Rect::of(0, 0, 600, 400);
        PrintSetup setup;
        setup.landscape = true;
        setup.margins = {10, 20, 30, 40};
        const PagePlan fitted = planOf(setup, area);
        QCOMPARE(fitted.paper, QSizeF(842 / 72.0 * 25.4, 595 / 72.0 * 25.4)); // A4 in whole points
        QCOMPARE(fitted.room, QRectF(10, 20, fitted.paper.width() - 40, fitted.paper.height() - 60));
        const double height = fitted.room.height(), width = 1.5 * height;
        QCOMPARE(fitted.picture, QRectF(10 + 0.5 * (fitted.room.width() - width), 20, width, height));
        QVERIFY(!fitted.isCut());
        setup.size = PrintSetup::Size::Actual;
        const PagePlan actual = planOf(setup, area);
        QVERIFY(std::abs(actual.picture.width() - 101.6) < 1e-9);
        QVERIFY(std::abs(actual.picture.height() - 67.733) < 1e-3);
        QCOMPARE(actual.picture.center(), actual.room.center());
        QVERIFY(std::abs(planOf(setup, area, 300).picture.width() - 50.8) < 1e-9);
        setup.size = PrintSetup::Size::Scaled;
        setup.scale = 400;
        const PagePlan large = planOf(setup, area);
        QVERIFY(std::abs(large.picture.width() - 406.4) < 1e-9);
        QVERIFY(large.isCut());
        // What is seen of it is what the margins leave, and its middle is the canvas's.
        QCOMPARE(large.dots(254), (PixelRect{100, 200, 2570, 1499}));
        const View view = large.view(254);
        QVERIFY(length(view.centre - Point{300, 200}) < 0.5 * 150 / 254 / 4); // half a dot
        QVERIFY(std::abs(view.scale - 254 / 150.0 * 4) < 1e-9);
        setup.margins = {150, 0, 150, 0};
        QVERIFY(planOf(setup, area).isEmpty());
    }

    void theSizeOnPaperIsThePaintings()
    {
        Editor editor;
        Canvas canvas;
        canvas.width = 600, canvas.height = 400;
        editor.newPainting(canvas, 300);
        PrintDialog dialog(editor, {});
        QCOMPARE(dialog.sizeBox()->currentData().toInt(), int(PrintSetup::Size::Actual)); // since it says so
        QVERIFY(std::abs(dialog.plan().picture.width() - 50.8) < 1e-9);
    }

    /// All of a sheet that is the painting's own is painted, without margins; other paper has its margins again.
    void thePaintingsOwnSheetIsPaper()
    {
        Editor editor;
        fill(editor);
        PrintDialog dialog(editor, {});
        dialog.show();
        dialog.margins()[2]->setValue(17);
        choose(dialog.paper(), "Sheet");
        QVERIFY2(dialog.paper()->currentText().contains("102 × 67.7"), qPrintable(dialog.paper()->currentText()));
        QVERIFY(!dialog.orientation()->isEnabled());
        const PagePlan plan = dialog.plan();
        QCOMPARE(plan.paper, QSizeF(600 / 150.0 * 25.4, 400 / 150.0 * 25.4));
        QCOMPARE(plan.picture, QRectF(QPointF(), plan.paper));
        QVERIFY(!plan.isCut());
        choose(dialog.paper(), "A4");
        QVERIFY(dialog.orientation()->isEnabled());
        QCOMPARE(dialog.margins()[2]->value(), 17.0);
        choose(dialog.paper(), "Sheet");
        choose(dialog.resolution(), 300);
        print(dialog, m_folder.filePath("sheet.pdf"));
        QCOMPARE(PrintDialog(editor, {}).plan().paper, plan.paper);
        if (QStandardPaths::findExecutable("pdftoppm").isEmpty())
            QSKIP("pdftoppm is not installed.");
        const QImage page = drawn(m_folder.filePath("sheet.pdf"), 300);
        QCOMPARE(page.size(), QSize(1200, 800));
        QVERIFY(meanDifference(page, expected(editor, plan, 300, true)) <= 0.05);
    }

    void popplerFindsThePicture_data()
    {
        QTest::addColumn<int>("size");
        QTest::addColumn<bool>("background");
        QTest::addRow("fitted") << int(PrintSetup::Size::FitPage) << true;
        QTest::addRow("actual size") << int(PrintSetup::Size::Actual) << true;
        QTest::addRow("without background") << int(PrintSetup::Size::FitPage) << false;
        QTest::addRow("cut") << int(PrintSetup::Size::Scaled) << true;
    }
    void popplerFindsThePicture()
    {
        if (QStandardPaths::findExecutable("pdftoppm").isEmpty())
            QSKIP("pdftoppm is not installed.");
        QFETCH(int, size);
        QFETCH(bool, background);
        Editor editor;
        fill(editor);
        PrintDialog dialog(editor, {});
        dialog.show();
        choose(dialog.paper(), "A5");
        dialog.scale()->setValue(300);
        choose(dialog.sizeBox(), size);
        choose(dialog.resolution(), 300);
        dialog.background()->setChecked(background);
        const PagePlan plan = dialog.plan();
        QCOMPARE(plan.isCut(), PrintSetup::Size(size) == PrintSetup::Size::Scaled);
        print(dialog, m_folder.filePath("a.pdf"));
        QCOMPARE(dialog.result(), int(QDialog::Accepted));
        const double fine =
            meanDifference(drawn(m_folder.filePath("a.pdf"), 300), expected(editor, plan, 300, background));
        const double coarse =
            meanDifference(drawn(m_folder.filePath("a.pdf"), 75), expected(editor, plan, 75, background));
        qInfo("mean difference %.4f of 255 at 300 dpi, %.4f at 75", fine, coarse);
        QVERIFY2(fine <= 0.05, qPrintable(QString::number(fine)));
        // There it takes the mean of 4 × 4 dots; seams would show.
        QVERIFY2(coarse <= 0.5, qPrintable(QString::number(coarse)));
    }

    /// A device that is no file gets the very dots, one after the other, when all of them are there.
    void aPrinterGetsTheSamePage()
    {
        Editor editor;
        fill(editor);
        PrintSetup setup;
        setup.paper = "A6";
        PageOrder order{editor.document().painting(), editor.document().painting()->end(),
                        planOf(setup, editor.document().painting()->canvas.area())};
        PrintTarget target;
        target.layout = layoutOf(setup);
        target.dpi = 300;
        PrintJob job;
        QSignalSpy finished(&job, &PrintJob::finished), handed(&job, &PrintJob::handedOver);
        QBuffer paper;
        QVERIFY(paper.open(QIODevice::WriteOnly));
        auto printer = std::make_shared<QPdfWriter>(&paper);
        printer->setResolution(300);
        QPageLayout whole = target.layout;
        whole.setMode(QPageLayout::FullPageMode);
        printer->setPageLayout(whole);
        target.printer = printer;
        job.print(order, target);
        QTRY_COMPARE_WITH_TIMEOUT(finished.size(), 1, waitMs);
        QVERIFY(finished.front().at(0).toBool());
        QCOMPARE(handed.size(), 1);
        QFile file(m_folder.filePath("printer.pdf"));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(paper.data()) == paper.size());
        file.close();
        if (!QStandardPaths::findExecutable("pdftoppm").isEmpty())
            QVERIFY(meanDifference(drawn(file.fileName(), 300), expected(editor, order.plan, 300, true)) <= 0.05);
        // What is cancelled before is not given to it.
        finished.clear(), handed.clear();
        paper.buffer().clear();
        paper.seek(0);
        order.plan = planOf({.paper = "A2"}, order.plan.area);
        target.dpi = 600;
        job.print(order, target);
        QTest::qWait(50);
        job.cancel();
        QTRY_COMPARE_WITH_TIMEOUT(finished.size(), 1, waitMs);
        QCOMPARE(finished.front().at(0).toBool(), false);
        QCOMPARE(finished.front().at(1).toString(), QString());
        QCOMPARE(handed.size(), 0);
        QCOMPARE(paper.size(), 0);
    }

    /// A large page takes as little memory as a small one, and stops at once.
    void largePagesTakeLittleMemoryAndStop()
    {
        Editor editor;
        fill(editor);
        QFile other(m_folder.filePath("a.pdf"));
        QVERIFY(other.open(QIODevice::WriteOnly) && other.write("before") == 6);
        other.close();
        PrintDialog dialog(editor, {});
        dialog.show();
        choose(dialog.paper(), "A3");
        choose(dialog.resolution(), 1200);
        QTRY_VERIFY_WITH_TIMEOUT(!dialog.page()->sheet().isNull(), waitMs);
        dialog.path()->setText(m_folder.filePath("b.pdf"));
        forgetPeak();
        const long before = memory("VmRSS:");
        dialog.exportButton()->click();
        QVERIFY(dialog.isExporting());
        QTRY_VERIFY_WITH_TIMEOUT(dialog.findChild<QProgressBar *>()->value() >= 100, waitMs);
        QElapsedTimer clock;
        clock.start();
        dialog.reject();
        QTRY_VERIFY_WITH_TIMEOUT(!dialog.isExporting(), waitMs);
        const long more = (memory("VmHWM:") - before) / 1024;
        qInfo("stopped after %lld ms; %ld MiB more at the most", clock.elapsed(), more);
        QVERIFY(dialog.isVisible()); // so that it can be tried again
        QVERIFY(dialog.exportButton()->isEnabled());
        QCOMPARE(files(), QStringList{"a.pdf"});
        QVERIFY2(more < 256, qPrintable(QString::number(more))); // all of the page would be a GiB
    }

    /// All of an A3 page with 1,200 dots an inch, which are 278 million.
    void allOfALargePage()
    {
        if (!qEnvironmentVariableIsSet("SUFFUSE_LONG"))
            QSKIP("It takes minutes: SUFFUSE_LONG=1 runs it.");
        Editor editor;
        fill(editor);
        PrintDialog dialog(editor, {});
        dialog.show();
        choose(dialog.paper(), "A3");
        choose(dialog.resolution(), 1200);
        QTRY_VERIFY_WITH_TIMEOUT(!dialog.page()->sheet().isNull(), waitMs);
        forgetPeak();
        const long before = memory("VmRSS:");
        QElapsedTimer clock;
        clock.start();
        dialog.path()->setText(m_folder.filePath("a.pdf"));
        dialog.exportButton()->click();
        QTRY_VERIFY_WITH_TIMEOUT(!dialog.isVisible(), 20 * waitMs);
        const long more = (memory("VmHWM:") - before) / 1024;
        qInfo("%.1f s, %ld MiB more at the most, %lld MiB", double(clock.elapsed()) / 1000, more,
              QFileInfo(m_folder.filePath("a.pdf")).size() >> 20);
        QVERIFY(more < 256);
        if (QStandardPaths::findExecutable("pdftoppm").isEmpty())
            return;
        const double coarse =
            meanDifference(drawn(m_folder.filePath("a.pdf"), 60), expected(editor, dialog.plan(), 60, true));
        qInfo("mean difference %.4f of 255 at 60 dpi", coarse);
        QVERIFY(coarse <= 1);
    }

    void theDocumentKeepsThePage()
    {
        Editor editor;
        fill(editor);
        PrintDialog dialog(editor, {});
        dialog.show();
        QCOMPARE(dialog.orientation()->currentData().toBool(), true); // as the canvas is
        PrintSetup setup;
        setup.paper = "A6";
        setup.margins = {5, 6, 7, 8};
        setup.size = PrintSetup::Size::Scaled;
        setup.scale = 50;
        setup.area = PrintSetup::Area::Numbers;
        setup.numbers = Rect::of(10, 20, 300, 200);
        setup.moment = PrintSetup::Moment::Time;
        setup.time = 1'500'000;
        setup.background = false;
        setup.dpi = 72;
        dialog.take(setup);
        QCOMPARE(dialog.setup(), setup);
        QVERIFY(!editor.extras().view); // not before it is printed
        print(dialog, m_folder.filePath("a.pdf"));
        QVERIFY(editor.extras().view && editor.extras().view->print == setup);
        const QString path = m_folder.filePath("a.suffuse");
        QVERIFY(saveDocument(*editor.document().painting(), editor.extras(), path));
        Editor again;
        QVERIFY(again.open(path));
        PrintDialog next(again, {});
        QCOMPARE(next.setup(), setup);
    }

    void thePreviewIsThePage()
    {
        Editor editor;
        fill(editor);
        PrintDialog dialog(editor, {});
        dialog.show();
        QTRY_VERIFY_WITH_TIMEOUT(!dialog.page()->sheet().isNull(), waitMs);
        const auto difference = [&](bool background) {
            return meanDifference(dialog.page()->sheet(),
                                  expected(editor, dialog.plan(), dialog.page()->dpi(), background));
        };
        QTRY_VERIFY_WITH_TIMEOUT(difference(true) <= 0.01, waitMs);
        // Whatever is chosen is shown.
        dialog.background()->setChecked(false);
        choose(dialog.paper(), "A5");
        QVERIFY(difference(false) > 0.01);
        QTRY_VERIFY_WITH_TIMEOUT(difference(false) <= 0.01, waitMs);
    }

    void numbersAreThoseOfTheLanguage()
    {
        const QLocale usual;
        const auto restore = qScopeGuard([&] { QLocale::setDefault(usual); });
        QLocale::setDefault(QLocale(QLocale::German));
        Editor editor;
        fill(editor);
        PrintDialog dialog(editor, {});
        dialog.show();
        for (const QDoubleSpinBox *margin : dialog.margins())
            QCOMPARE(margin->text(), QString("10,0 mm"));
        QCOMPARE(dialog.scale()->text(), QString("100,0 %"));
        QVERIFY2(dialog.said()->text().contains("mm"), qPrintable(dialog.said()->text()));
    }

    void whatWillHappenIsSaid()
    {
        Editor editor;
        fill(editor);
        PrintDialog dialog(editor, {});
        dialog.show();
        choose(dialog.paper(), "A4");
        choose(dialog.orientation(), true);
        chooseSize(dialog, PrintSetup::Size::Actual);
        QCOMPARE(dialog.said()->text(), "The picture is 102 × 67.7 mm on the paper.");
        dialog.scale()->setValue(500);
        QCOMPARE(dialog.sizeBox()->currentData().toInt(), int(PrintSetup::Size::Scaled));
        QCOMPARE(dialog.said()->text(), "The picture is 508 × 339 mm on the paper. What does not fit is cut off.");
        dialog.margins()[0]->setValue(400);
        QCOMPARE(dialog.said()->text(), "The margins leave no room on the paper.");
        QVERIFY(!dialog.exportButton()->isEnabled());
        dialog.margins()[0]->setValue(0);
        QVERIFY(dialog.exportButton()->isEnabled());
    }

private:
    static constexpr int waitMs = 60'000;
    QTemporaryDir m_folder, m_settings;
};

QTEST_MAIN(TestPrintDialog)
#include "test_print_dialog.moc"
