export { answered, api, csrfToken, newIdempotencyKey } from './client'
export { everyPage } from './pages'
export { ApiProblem, type FieldProblem, lineLost, problemOf } from './problem'
export { queryClient } from './queryClient'
