#ifndef rolling_contact_linear_algebra_blas_h
#define rolling_contact_linear_algebra_blas_h

#include <complex>

/**
 * The Fortran BLAS and LAPACK routines in use, with 32-bit integers.
 */
extern "C" {
void
dgemv_(const char   *trans,
       const int    *m,
       const int    *n,
       const double *alpha,
       const double *a,
       const int    *lda,
       const double *x,
       const int    *incx,
       const double *beta,
       double       *y,
       const int    *incy);

void
dgemm_(const char   *transa,
       const char   *transb,
       const int    *m,
       const int    *n,
       const int    *k,
       const double *alpha,
       const double *a,
       const int    *lda,
       const double *b,
       const int    *ldb,
       const double *beta,
       double       *c,
       const int    *ldc);

void
dtrsm_(const char   *side,
       const char   *uplo,
       const char   *transa,
       const char   *diag,
       const int    *m,
       const int    *n,
       const double *alpha,
       const double *a,
       const int    *lda,
       double       *b,
       const int    *ldb);

void
dsyrk_(const char   *uplo,
       const char   *trans,
       const int    *n,
       const int    *k,
       const double *alpha,
       const double *a,
       const int    *lda,
       const double *beta,
       double       *c,
       const int    *ldc);

void
dposv_(const char *uplo,
       const int  *n,
       const int  *nrhs,
       double     *a,
       const int  *lda,
       double     *b,
       const int  *ldb,
       int        *info);

void
dpbsv_(const char *uplo,
       const int  *n,
       const int  *kd,
       const int  *nrhs,
       double     *ab,
       const int  *ldab,
       double     *b,
       const int  *ldb,
       int        *info);

void
dgesv_(const int *n,
       const int *nrhs,
       double    *a,
       const int *lda,
       int       *ipiv,
       double    *b,
       const int *ldb,
       int       *info);

void
dgels_(const char *trans,
       const int  *m,
       const int  *n,
       const int  *nrhs,
       double     *a,
       const int  *lda,
       double     *b,
       const int  *ldb,
       double     *work,
       const int  *lwork,
       int        *info);

void
dsyevr_(const char   *jobz,
        const char   *range,
        const char   *uplo,
        const int    *n,
        double       *a,
        const int    *lda,
        const double *vl,
        const double *vu,
        const int    *il,
        const int    *iu,
        const double *abstol,
        int          *m,
        double       *w,
        double       *z,
        const int    *ldz,
        int          *isuppz,
        double       *work,
        const int    *lwork,
        int          *iwork,
        const int    *liwork,
        int          *info);

void
dsyevd_(const char *jobz,
        const char *uplo,
        const int  *n,
        double     *a,
        const int  *lda,
        double     *w,
        double     *work,
        const int  *lwork,
        int        *iwork,
        const int  *liwork,
        int        *info);

void
zgemm_(const char                 *transa,
       const char                 *transb,
       const int                  *m,
       const int                  *n,
       const int                  *k,
       const std::complex<double> *alpha,
       const std::complex<double> *a,
       const int                  *lda,
       const std::complex<double> *b,
       const int                  *ldb,
       const std::complex<double> *beta,
       std::complex<double>       *c,
       const int                  *ldc);

void
zgetrf_(const int            *m,
        const int            *n,
        std::complex<double> *a,
        const int            *lda,
        int                  *ipiv,
        int                  *info);

void
zgetrs_(const char                 *trans,
        const int                  *n,
        const int                  *nrhs,
        const std::complex<double> *a,
        const int                  *lda,
        const int                  *ipiv,
        std::complex<double>       *b,
        const int                  *ldb,
        int                        *info);

void
dgeev_(const char *jobvl,
       const char *jobvr,
       const int  *n,
       double     *a,
       const int  *lda,
       double     *wr,
       double     *wi,
       double     *vl,
       const int  *ldvl,
       double     *vr,
       const int  *ldvr,
       double     *work,
       const int  *lwork,
       int        *info);

void
dsyev_(const char *jobz,
       const char *uplo,
       const int  *n,
       double     *a,
       const int  *lda,
       double     *w,
       double     *work,
       const int  *lwork,
       int        *info);

void
dgesvd_(const char *jobu,
        const char *jobvt,
        const int  *m,
        const int  *n,
        double     *a,
        const int  *lda,
        double     *s,
        double     *u,
        const int  *ldu,
        double     *vt,
        const int  *ldvt,
        double     *work,
        const int  *lwork,
        int        *info);

void
zgesvd_(const char           *jobu,
        const char           *jobvt,
        const int            *m,
        const int            *n,
        std::complex<double> *a,
        const int            *lda,
        double               *s,
        std::complex<double> *u,
        const int            *ldu,
        std::complex<double> *vt,
        const int            *ldvt,
        std::complex<double> *work,
        const int            *lwork,
        double               *rwork,
        int                  *info);
}

#endif
