/** The report of the game's CI on one build. */
export const build = (label: string, rejected: number, warnings: number, files = 12) => ({
  id: `b${label}`,
  label,
  commit: '',
  target: 'game',
  files,
  rejected,
  warnings,
  created_at: '2026-11-20T10:00:00Z',
})
const finding = (severity: string, message: string, more = {}) => ({
  code: 'a:b',
  severity,
  message,
  fix: 'render it again',
  ...more,
})
export const REPORT = {
  files: [
    {
      path: 'assets/airlock.wav',
      verdict: 'rejected',
      findings: [
        finding('error', 'sample rate 44100 Hz, accepted 48000 Hz'),
        finding('warning', 'true peak 0.6 dBTP, limit -1 dBTP'),
      ],
    },
    {
      path: 'assets/let_through.wav',
      verdict: 'rejected',
      findings: [finding('error', 'sample peak 0.00 dBFS, limit -0.1 dBFS', { waived: true })],
    },
    { path: 'assets/broken.wav', verdict: 'unreadable', findings: [] },
    { path: 'assets/fine.wav', verdict: 'conforming', findings: [] },
  ],
}
