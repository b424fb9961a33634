// The colours of exported pictures: sRGB, or a profile that the painting keeps.
#include "app/dialogs/export/export_dialog.h"
#include "app/dialogs/export/profile_box.h"
#include "app/widgets/look/section.h"
#include "tests/app/file_dialogs.h"
#include "tests/app/panel_bench.h"
#include "tests/wide_profile.h"

#include <QPushButton>
#include <QSpinBox>
#include <QTemporaryDir>

using namespace suffuse;

class TestExportProfile : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;
    QString path(const char *name) const { return m_folder.filePath(QLatin1String(name)); }

    void exportTo(ExportDialog &dialog, const char *name) const
    {
        dialog.path()->setText(path(name));
        dialog.widthBox()->setValue(48);
        QTest::mouseClick(dialog.exportButton(), Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(dialog.result(), int(QDialog::Accepted), 20000);
    }

private slots:
    void initTestCase()
    {
        qputenv("SUFFUSE_SETTINGS", path("settings.ini").toUtf8());
        QVERIFY(put(path("wide.icc"), test::wideProfile()) && put(path("broken.icc"), "no profile"));
    }

    /// It is chosen from a file once, and is in the painting's file from then on.
    void thePaintingKeepsIt()
    {
        Bench bench;
        {
            ExportDialog dialog(bench.editor, {});
            dialog.show();
            QCOMPARE(dialog.colours()->currentText(), QStringLiteral("sRGB"));
            QCOMPARE(dialog.colours()->count(), 2);
            int chosen = 0;
            whenAskedForFile(&dialog, chosen, path("wide.icc"));
            emit dialog.colours()->activated(1);
            QCOMPARE(chosen, 1);
            QCOMPARE(dialog.colours()->profile(), test::wideProfile());
            exportTo(dialog, "wide.png");
        }
        QCOMPARE(embeddedProfile(bytesOf(path("wide.png")), ImageFormat::Png), test::wideProfile());
        QCOMPARE(bench.editor.extras().profile, test::wideProfile());
        bench.editor.startSaving(path("kept.suffuse"));
        QTRY_VERIFY_WITH_TIMEOUT(!bench.editor.filePath().isEmpty() && !bench.editor.isSaving(), 20000);

        Bench later;
        QVERIFY(later.editor.open(path("kept.suffuse")));
        ExportDialog dialog(later.editor, {});
        dialog.show();
        QCOMPARE(dialog.colours()->profile(), test::wideProfile());
        const ExportSettings settings = dialog.settings();
        QVERIFY(settings.usesProfile);
        const Result<ExportOrder> again = exportOrder(settings, later.editor, {});
        QVERIFY2(again, again ? "" : qPrintable(again.error()));
        QCOMPARE(again->image.profile, test::wideProfile());
        dialog.colours()->chooseKept(false);
        exportTo(dialog, "plain.png");
        QVERIFY(embeddedProfile(bytesOf(path("plain.png")), ImageFormat::Png).isEmpty());
        QCOMPARE(later.editor.extras().profile, test::wideProfile()); // It may be wanted again.
        later.editor.newPainting(Canvas{});
        QVERIFY(later.editor.extras().profile.isEmpty());
    }

    void whatCannotBe()
    {
        Bench bench;
        ExportDialog dialog(bench.editor, {});
        dialog.show();
        for (const char *wrong : {"broken.icc", "gone.icc"}) {
            const QString problem = dialog.colours()->takeFile(path(wrong));
            QVERIFY2(problem.contains(QLatin1String(wrong)), qPrintable(problem));
            QCOMPARE(dialog.colours()->count(), 2);
            QVERIFY(dialog.colours()->profile().isEmpty());
        }
        QVERIFY(dialog.colours()->takeFile(path("wide.icc")).isEmpty());
        for (const char *name : {"a.exr", "a.pfm", "a.ora", "a.psd"}) {
            dialog.path()->setText(path(name));
            QVERIFY2(!dialog.colours()->isEnabled(), name);
        }
        for (const char *name : {"a.png", "a.tif", "a.jpg", "a.webp"}) {
            dialog.path()->setText(path(name));
            QVERIFY2(dialog.colours()->isEnabled(), name);
        }
        exportTo(dialog, "a.jpg");
        QCOMPARE(embeddedProfile(bytesOf(path("a.jpg")), ImageFormat::Jpeg), test::wideProfile());
        bench.editor.extras().profile = "no profile"; // as a file may have it
        ExportDialog other(bench.editor, {});
        QVERIFY(other.colours()->profile().isEmpty());
    }
};

QTEST_MAIN(TestExportProfile)
#include "test_export_profile.moc"
