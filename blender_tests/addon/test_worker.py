"""The worker process: cancelled, killed, superseded; and what it leaves behind."""


def started(resolution=1024):
    """A job that has got going, on a map large enough to be met at work."""
    import bpy
    import steps

    jobs = steps.addon("worker.jobs").jobs
    terrain = steps.corsica(resolution=resolution, seed=777)
    recipe = steps.addon("settings_recipe").to_recipe(terrain, bpy.context.scene)
    job = jobs.start(recipe)
    while job.fraction == 0 and job.state == "RUNNING":
        jobs.poll()
    assert job.state == "RUNNING", job
    return jobs, job, recipe


def test_cancelled_job_ends_and_the_next_is_right():
    import numpy as np
    import orogen

    jobs, job, recipe = started()
    pid = jobs.worker_pid
    jobs.cancel(job)
    assert job.state == "CANCELLED"
    small = {**recipe, "resolution": 64, "seed": 3}
    following = jobs.wait(jobs.start(small), timeout=60)
    assert following.state == "DONE", following
    assert jobs.worker_pid == pid, "the worker did not survive the cancelled job"
    expected = orogen.generate(orogen.Recipe.from_dict(small))["elevation"]
    assert np.array_equal(following.result.fields["elevation"], expected)
    following.result.close()


def test_cancelling_interrupts_the_computation():
    import time

    jobs, job, _recipe = started(resolution=2048)
    worker = jobs._worker
    begin = time.monotonic()
    jobs.cancel(job)
    while (answer := worker.poll(timeout=10.0)) and answer["say"] == "progress":
        pass
    assert answer and answer["say"] == "cancelled"
    assert time.monotonic() - begin < 0.5


def test_killed_worker_costs_a_message():
    import os
    import signal

    jobs, job, recipe = started()
    os.kill(jobs.worker_pid, signal.SIGKILL)
    jobs.wait(job, timeout=30)
    assert job.state == "FAILED" and "SIGKILL" in job.message
    again = jobs.wait(jobs.start({**recipe, "resolution": 64}), timeout=60)
    assert again.state == "DONE", again
    again.result.close()


def test_killed_worker_leaves_the_terrain(tmp_path):
    import os
    import signal
    import threading

    import bpy
    import numpy as np
    import steps

    terrain = steps.corsica(resolution=64)
    steps.grow()
    before = steps.positions(terrain).copy()
    terrain.orogen.resolution, terrain.orogen.seed = 1024, 777
    jobs = steps.addon("worker.jobs").jobs
    threading.Timer(0.3, lambda: os.kill(jobs.worker_pid, signal.SIGKILL)).start()
    message = steps.refused(bpy.ops.orogen.grow)
    assert "crashed" in message
    assert np.array_equal(steps.positions(terrain), before)
    assert bpy.context.window_manager.orogen.is_error


def test_latest_job_wins():
    jobs, job, recipe = started()
    latest = jobs.start({**recipe, "resolution": 64})
    assert job.state == "SUPERSEDED"
    assert jobs.wait(latest, timeout=60).state == "DONE"
    assert job.state == "SUPERSEDED" and job.result is None
    latest.result.close()


def test_files_are_gone_in_every_case():
    import os
    import signal
    import time

    jobs, job, _recipe = started()
    folder = jobs._worker.exchange
    assert folder.is_dir()
    os.kill(jobs.worker_pid, signal.SIGKILL)
    jobs.wait(job, timeout=30)
    assert not folder.exists()

    jobs, job, _recipe = started()
    folder = jobs._worker.exchange
    jobs.shutdown()
    assert not folder.exists()

    jobs, job, _recipe = started()
    folder = jobs._worker.exchange
    jobs._worker._process.stdin.close()  # what the death of the host looks like
    for _ in range(100):
        if not folder.exists():
            break
        time.sleep(0.1)
    assert not folder.exists()


def test_worker_of_a_dead_host_ends(tmp_path):
    """A host that is killed in the middle of a job leaves no process and no file."""
    import os
    import signal
    import subprocess
    import sys
    import time

    import steps

    launch = steps.addon("worker.launch")
    program = (
        "import subprocess, sys, time; p = subprocess.Popen(sys.argv[1:], stdin=subprocess.PIPE);"
        "print(p.pid, flush=True); time.sleep(600)"
    )
    command = [sys.executable, "-c", program, *launch.command(tmp_path / "exchange")]
    host = subprocess.Popen(command, env=launch.environment(), stdout=subprocess.PIPE, text=True)
    pid = int(host.stdout.readline())
    while not (tmp_path / "exchange").exists():
        time.sleep(0.05)
    os.kill(host.pid, signal.SIGKILL)
    host.wait()
    for _ in range(100):
        try:
            os.kill(pid, 0)
        except ProcessLookupError:
            break
        time.sleep(0.1)
    else:
        raise AssertionError("the worker outlived its host")
    assert not (tmp_path / "exchange").exists()
