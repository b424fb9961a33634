// The manual: a window beside the others, in the language of the program.
#pragma once

#include "app/dialogs/manual/manual_pages.h"

#include <QWidget>

class QLineEdit;
class QListWidget;
class QListWidgetItem;
class QToolButton;

namespace suffuse {

class PageView;

/// Contents and search on the left, a page on the right; back and forward go through the pages that were read. There is
/// one for the whole program, which waits for no answer and keeps the program from ending no longer than its windows do.
class ManualWindow : public QWidget {
    Q_OBJECT

public:
    explicit ManualWindow(QWidget *parent = nullptr);
    ~ManualWindow() override;

    /// Shows the program's manual and turns to a page; an empty name, or one that no page has, turns to the contents
    /// the first time, and afterwards to what was read last. `asking` is the window that asked: where it is modal, the
    /// manual can be used all the same.
    static ManualWindow *open(const QString &page, QWidget *asking);

    const ManualPages &pages() const { return m_pages; }
    /// The name of the page that is shown.
    QString page() const { return m_pages.all()[m_shown].name; }
    void turnTo(const QString &page);

    QLineEdit *search() const { return m_search; }
    QListWidget *list() const { return m_list; }
    PageView *view() const { return m_view; }
    QToolButton *back() const { return m_back; }
    QToolButton *forward() const { return m_forward; }

protected:
    void changeEvent(QEvent *event) override;
    void closeEvent(QCloseEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    /// A page that was read, and how far it was scrolled.
    struct Read {
        QString page;
        int scrolled = 0;
    };

    QWidget *makeContents();
    QWidget *makeReading();
    QToolButton *makeButton(const char *icon, const QKeySequence &keys, void (ManualWindow::*does)());
    void addKeys();
    void setTexts();
    void fill();
    void addHeading(const QString &text);
    QListWidgetItem *addPage(std::size_t page, const QString &excerpt = {});
    void showPage(const QString &page, const QStringList &words = {});
    void showChosen();
    void goBack();
    void goForward();
    void goHome();
    void setAnew();
    Read read() const;
    void goTo(const Read &read);
    void updateButtons();

    ManualPages m_pages;
    std::size_t m_shown = 0;
    std::vector<Read> m_before, m_after; ///< the last one is the nearest
    QLineEdit *m_search = nullptr;
    QListWidget *m_list = nullptr;
    PageView *m_view = nullptr;
    QToolButton *m_back = nullptr, *m_forward = nullptr, *m_home = nullptr;
};

} // namespace suffuse
