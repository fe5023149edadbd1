"""What must hold however often it happens. OROGEN_LONG=1: as often as the project promises."""


def rounds(short, long):
    import os

    return long if os.environ.get("OROGEN_LONG") else short


def test_worker_killed_at_random_moments():
    """The scene stays, a message comes within a second, and the next run is right."""
    import os
    import random
    import signal
    import threading
    import time

    import bpy
    import numpy as np
    import steps

    terrain = steps.corsica(resolution=64)
    steps.grow()
    right = steps.positions(terrain)
    jobs, session = steps.addon("worker.jobs").jobs, bpy.context.window_manager.orogen
    terrain.orogen.resolution = 1024
    begin = time.monotonic()
    steps.grow()
    longest = time.monotonic() - begin
    terrain.orogen.resolution = 64
    steps.grow()
    moments, killed, slowest = random.Random(1), 0, 0.0
    for i in range(rounds(15, 100)):
        terrain.orogen.resolution, terrain.orogen.seed = 1024, 1000 + i
        died = []

        def kill(pid, died=died):
            died.append(time.monotonic())
            os.kill(pid, signal.SIGKILL)

        if jobs.worker_pid is None:
            jobs.wait(jobs.start_preview({"orogen": 1, "stages": []}))  # starts a worker
        timer = threading.Timer(moments.uniform(0.0, 0.8 * longest), kill, [jobs.worker_pid])
        timer.start()
        try:
            bpy.ops.orogen.grow()
        except RuntimeError as error:
            killed += 1
            slowest = max(slowest, time.monotonic() - died[0])
            assert "SIGKILL" in str(error) and session.is_error, error
            assert np.array_equal(steps.positions(terrain), right)
        timer.join()
        while jobs.worker_pid is not None:  # until its end is known, where it had nothing to do
            time.sleep(0.01)
        terrain.orogen.resolution, terrain.orogen.seed = 64, 2
        steps.grow()
        assert np.array_equal(steps.positions(terrain), right)
        assert not session.message
    print(f"killed {killed} times; the message came after {slowest:.3f} s at most")
    assert killed > 0.8 * rounds(15, 100) and slowest < 1.0


def test_memory_of_the_worker_is_flat():
    import steps

    terrain = steps.collision_recipe()
    jobs = steps.addon("worker.jobs").jobs

    def resident():  # MiB
        with open(f"/proc/{jobs.worker_pid}/statm") as file:
            return int(file.read().split()[1]) * 4096 / 2**20

    def previews(count):
        """The memory after every tenth."""
        samples = []
        for i in range(count):
            terrain["phases"][0]["plates"][0]["arrows"][0][1] += 3.0
            job = jobs.wait(jobs.start_preview(terrain))
            assert job.state == "DONE", job
            job.result.close()
            if i % 10 == 9:
                samples.append(resident())
        return samples

    terrain["phases"][0]["plates"][0]["arrows"] = [[0.0, 3600.0] for _ in range(4)]
    previews(60)  # until the cache is full
    samples = previews(rounds(60, 1000))
    half = len(samples) // 2
    grown = min(samples[half:]) - min(samples[:half])  # what is free for a while does not count
    print(f"{min(samples):.0f} to {max(samples):.0f} MiB; {grown:+.1f} from one half to the other")
    # One preview's fields are 5 MiB: were they kept, half of the previews would be 150 or more.
    assert grown < 40.0 and max(samples) < 400.0
