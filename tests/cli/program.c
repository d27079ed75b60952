/* Starts programs and looks at what they leave. Every failure here fails the test that asked. */
#include "program.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <cmocka.h>

/* With `group` as the leader of a group of its own. Child and parent both see to that, for either
 * may be late: once the program runs, the parent cannot any more, and until the child has run, its
 * group is none. */
static pid_t start(const char *folder, const char *const *arguments, int out, int err, bool group)
{
    pid_t pid = fork();
    assert_true(pid >= 0);
    if (group)
        setpgid(pid, pid);
    if (pid == 0) {
        int null = open("/dev/null", O_RDWR);
        dup2(null, STDIN_FILENO);
        dup2(out >= 0 ? out : null, STDOUT_FILENO);
        dup2(err >= 0 ? err : null, STDERR_FILENO);
        if (folder && chdir(folder) != 0)
            _exit(126);
        bool own = strcmp(arguments[0], "skvalp") == 0;
        execvp(own ? SKV_BINARY_DIR "/skvalp" : arguments[0], (char *const *)arguments);
        _exit(127);
    }
    return pid;
}

static int status_of(int status)
{
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

static char *read_all(FILE *file, size_t *size)
{
    assert_int_equal(fseek(file, 0, SEEK_END), 0);
    long length = ftell(file);
    assert_true(length >= 0);
    assert_int_equal(fseek(file, 0, SEEK_SET), 0);
    char *text = malloc((size_t)length + 1);
    assert_non_null(text);
    assert_int_equal(fread(text, 1, (size_t)length, file), length);
    text[length] = '\0';
    if (size)
        *size = (size_t)length;
    return text;
}

program_result program_run(const char *folder, const char *const *arguments)
{
    program_result result = {0};
    FILE *out = tmpfile(), *err = tmpfile();
    int status;
    assert_true(out && err);
    pid_t pid = start(folder, arguments, fileno(out), fileno(err), false);
    while (waitpid(pid, &status, 0) == -1)
        assert_int_equal(errno, EINTR);
    result.status = status_of(status);
    result.out = read_all(out, &result.out_size);
    result.err = read_all(err, NULL);
    fclose(out);
    fclose(err);
    return result;
}

void program_free(program_result *result)
{
    free(result->out);
    free(result->err);
    *result = (program_result){0};
}

pid_t program_start(const char *folder, const char *const *arguments)
{
    return start(folder, arguments, -1, -1, true);
}

int program_wait(pid_t pid)
{
    int status;
    assert_int_equal(waitpid(pid, &status, 0), pid);
    return status_of(status);
}

int folder_setup(void **state)
{
    const char *base = getenv("TMPDIR");
    char *folder = malloc(4096);
    assert_non_null(folder);
    snprintf(folder, 4096, "%s/skvalp-test-XXXXXX", base ? base : "/tmp");
    assert_non_null(mkdtemp(folder));
    *state = folder;
    return 0;
}

int folder_teardown(void **state)
{
    program_result removed = program_run(NULL, (const char *const[]){"rm", "-rf", *state, NULL});
    int status = removed.status;
    program_free(&removed);
    free(*state);
    return status;
}

int folder_entries(const char *folder)
{
    DIR *directory = opendir(folder);
    int count = -2; /* . and .. */
    assert_non_null(directory);
    while (readdir(directory))
        count++;
    closedir(directory);
    return count;
}

void folder_await(const char *folder, int entries)
{
    while (folder_entries(folder) < entries)
        nanosleep(&(struct timespec){.tv_nsec = 10000000}, NULL);
}

static void path_in(char *path, const char *folder, const char *name)
{
    snprintf(path, 4096, "%s/%s", folder, name);
}

bool file_exists(const char *folder, const char *name)
{
    char path[4096];
    struct stat status;
    path_in(path, folder, name);
    return lstat(path, &status) == 0;
}

char *file_read(const char *folder, const char *name)
{
    char path[4096];
    path_in(path, folder, name);
    FILE *file = fopen(path, "rb");
    char *text = file ? read_all(file, NULL) : NULL;
    if (file)
        fclose(file);
    return text;
}

void file_write(const char *folder, const char *name, const char *text)
{
    char path[4096];
    path_in(path, folder, name);
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_true(fputs(text, file) >= 0);
    assert_int_equal(fclose(file), 0);
}

int count_lines(const char *text)
{
    int lines = 0;
    for (; *text; text++)
        lines += *text == '\n';
    return lines;
}
